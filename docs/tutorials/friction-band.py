# %% [markdown]
# # From two scans to a friction band
#
# Two height maps give one density, radius and height of asperities; another place gives others. How far does this scatter change friction?
#
# **The maps are SYNTHETIC**, made with the statistics of the paper's new ring; their numbers describe no real ring. The cylinder pressure is SYNTHETIC, too.

# %%
import matplotlib.pyplot as plt
import numpy as np
import ringfilm

ring = ringfilm.surface.read("cases/measured/ring_new.x3p")
liner = ringfilm.surface.read("cases/measured/liner.sur")
figure, panels = plt.subplots(1, 2, figsize=(8.5, 3.6), layout="constrained")
for axes, scan, title in zip(panels, (ring, liner), ("ring", "liner")):
    height = ringfilm.surface.prepare(scan.heights, scan.step, form="tilt")
    width = [n * step * 1e6 for n, step in zip(height.shape[::-1], scan.step)]
    picture = axes.imshow(height * 1e6, extent=(0, width[0], width[1], 0), cmap="cividis", vmin=-1.5, vmax=1.5)
    axes.set(title=title, xlabel="x [um]", ylabel="y [um]")
figure.colorbar(picture, ax=panels, label="height above the mean plane [um]", extend="both")
plt.show()

# %% [markdown]
# *The two synthetic maps with their tilt removed. White points were not measured.*
#
# ## N, beta and sigma of sixteen places
# Both maps are levelled and filtered between cut-offs of 1 and 80 um. Then each is cut into 4 x 4 parts; each part is a sample.


# %%
def parts(scan, n=4):
    level = ringfilm.surface.prepare(scan.heights, scan.step, form="tilt", short_cutoff=1e-6, long_cutoff=80e-6)
    rows, columns = (size // n for size in level.shape)
    return [
        ringfilm.surface.surface_measures(level[i * rows : (i + 1) * rows, j * columns : (j + 1) * columns], scan.step)
        for i in range(n)
        for j in range(n)
    ]


pairs = [ringfilm.surface.pair_parameters(one, other) for one, other in zip(parts(ring), parts(liner))]
samples = np.array([(pair.density_per_m2, pair.beta_m, pair.sigma_m) for pair in pairs])
for name, values, factor, unit in zip(("N", "beta", "sigma"), samples.T, (1e-12, 1e6, 1e6), ("1/um2", "um", "um")):
    print(
        f"{name:6s}{values.mean() * factor:8.4f} {unit:6s} "
        f"standard deviation {100 * values.std(ddof=1) / values.mean():.1f} %"
    )
print("correlations of their logarithms (N, beta, sigma):")
print(np.corrcoef(np.log(samples.T)).round(2))

# %% [markdown]
# The three are correlated. So they are drawn together, as a lognormal distribution with this covariance.

# %%
random = np.random.default_rng(2014)
draws = np.exp(random.multivariate_normal(np.log(samples).mean(axis=0), np.cov(np.log(samples.T)), size=200))
base = ringfilm.Case.read("cases/measured/new.toml")


def cases():
    for density, radius, roughness in draws:
        case = base.copy()
        case["contact.asperity_density"] = ringfilm.SI(density)
        case["contact.asperity_radius"] = ringfilm.SI(radius)
        case["contact.roughness"] = ringfilm.SI(roughness)
        yield case


batch = ringfilm.simulate_many(cases())
assert not batch.unsolved, batch.unsolved
angle = (batch[0].crank_angle + 360) % 720 - 360
order = np.argsort(angle)
friction = np.array([result.total_friction for result in batch])[:, order]

# %%
low, first, middle, third, high = np.quantile(friction, [0.05, 0.25, 0.5, 0.75, 0.95], axis=0)
figure, axes = plt.subplots(figsize=(7.5, 3.8), layout="constrained")
axes.fill_between(angle[order], low, high, color="#0072B2", alpha=0.25, linewidth=0, label="90 % of the draws")
axes.fill_between(angle[order], first, third, color="#0072B2", alpha=0.45, linewidth=0, label="50 %")
axes.plot(angle[order], middle, color="black", linewidth=1, label="median")
axes.set(xlim=(-360, 360), ylim=(0, None), xlabel="crank angle [degree], 0 = firing TDC", ylabel="total friction [N]")
axes.set_xticks(range(-360, 361, 90))
axes.legend(fontsize=8)
plt.show()
fmep = np.array([result.fmep for result in batch])
print(
    f"FMEP {np.median(fmep) / 1e3:.2f} kPa, "
    f"90 % between {np.quantile(fmep, 0.05) / 1e3:.2f} and {np.quantile(fmep, 0.95) / 1e3:.2f} kPa"
)

# %% [markdown]
# *Total friction with the scatter between sixteen places of the maps. Each angle has its own quantiles.*
#
# A whole ring is nearer to the mean of the places, with a narrower band; on the other hand shear strength, tension and oil temperature scatter, too. `ringfilm pair --fragment` writes mean, deviations and correlations into a case, which [a study](../manual/study.md) with `[[measured]]` uses: `cases/studies/life_states_measured.toml`.
