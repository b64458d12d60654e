#include "measured_chain.hpp"

namespace ringfilm::app::chain {

instrument::SurfaceAnalysis surface_analysis() {
  instrument::SurfaceAnalysis analysis;
  analysis.preparation.form = {surface::FormKind::tilt, 2};
  analysis.preparation.short_cutoff_m = 1e-6;
  analysis.preparation.long_cutoff_m = 80e-6;
  analysis.regions.across = analysis.regions.down = 2;
  analysis.sigma_rule = surface::SigmaRule::ra;
  return analysis;
}

surface::FaceRule face_rule() {
  surface::FaceRule rule;
  rule.sense = surface::HeightSense::kMaterial;
  rule.width_m = 1.2e-3;
  rule.start_m = 0.1e-3;
  rule.levelling = surface::FaceLevelling::kStated;
  rule.tilt = 2e-3;
  rule.zero = surface::FaceZero::kAsMeasured;
  return rule;
}

instrument::ForceRule force_rule() { return {}; }

surface::Uncertain silicon_reference() { return surface::kSiliconWarmack; }

}  // namespace ringfilm::app::chain
