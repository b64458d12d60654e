# %% [markdown]
# # What moves the friction coefficient at TDC?
#
# At firing top dead centre (TDC) the ring is at rest for an instant, the gas presses it hard, and the film has only what the squeeze leaves. The friction coefficient $\mu=f_t/W$ there decides how much the ring wears near the top of the stroke. Which input moves it most?
#
# **The case:** the new ring of styles2014, 1500 rpm, 120 °C. Its cylinder pressure is SYNTHETIC. **The ranges** below are ASSUMED: what a careful laboratory might leave open in each input, not what somebody measured.

# %%
import matplotlib.pyplot as plt
import numpy as np
import ringfilm

base = ringfilm.Case.read("cases/styles2014/new.toml")
# key, name, lowest and highest value as a factor of the base's, or as a step on it
inputs = [
    ("contact.boundary_shear_strength_coefficient", "boundary shear strength ±15 %", 0.85, 1.15),
    ("contact.roughness", "roughness ±10 %", 0.9, 1.1),
    ("contact.asperity_density", "asperity density ±20 %", 0.8, 1.2),
    ("contact.asperity_radius", "asperity radius ±15 %", 0.85, 1.15),
    ("ring.elastic_pressure", "ring tension ±20 %", 0.8, 1.2),
    ("operating.oil_temperature", "oil temperature ±10 K", -10.0, 10.0),
    ("operating.speed", "speed ±20 %", 0.8, 1.2),
]


def changed(key, step):
    case = base.copy()
    case[key] = ringfilm.SI(base[key] + step if key == "operating.oil_temperature" else base[key] * step)
    return case


cases = [base] + [changed(key, step) for key, _, *steps in inputs for step in steps]
batch = ringfilm.simulate_many(cases)
assert not batch.unsolved, batch.unsolved

# %% [markdown]
# All cases were computed side by side. Now the friction coefficient at 0 degrees, and its highest value within 60 degrees of firing TDC.

# %%
at_tdc = np.array([result["friction_coefficient"][np.argmin(np.abs(result.crank_angle))] for result in batch])
highest = np.array([result.peak_friction_coefficient_firing for result in batch])

figure, panels = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True, layout="constrained")
order = np.argsort(np.abs(at_tdc[2::2] - at_tdc[1::2]))
for axes, values, title in zip(
    panels, (at_tdc, highest), ("at firing TDC (0 degree)", "highest within 60 degree of it")
):
    for row, i in enumerate(order):
        low, high = values[1 + 2 * i], values[2 + 2 * i]
        axes.barh(row, low - values[0], left=values[0], color="#0072B2", label="lowest input" if row == 0 else None)
        axes.barh(
            row,
            high - values[0],
            left=values[0],
            color="#E69F00",
            hatch="//",
            label="highest input" if row == 0 else None,
        )
    axes.axvline(values[0], color="black", linewidth=0.8)
    axes.set_xlabel("friction coefficient [-]")
    axes.set_title(title, fontsize=10)
panels[0].set_yticks(range(len(inputs)), [inputs[i][1] for i in order])
panels[1].legend(fontsize=8, loc="lower right")
plt.show()

# %% [markdown]
# *Friction coefficient of the new ring when one input at a time goes to the lowest and the highest value of its range. The line is the unchanged case.*
#
# One input has by far the largest effect. The reason is what carries the load at TDC:

# %%
at = np.argmin(np.abs(batch[0].crank_angle))
now = batch[0]
print(f"load {now.applied_load[at]:.0f} N")
print(f"  carried by asperities {100 * now.asperity_load[at] / now.applied_load[at]:.1f} %")
print(f"  carried by the film   {100 * now.hydrodynamic_load[at] / now.applied_load[at]:.1f} %")
print(f"friction of asperities {now.boundary_friction[at]:.1f} N, of the oil {now.viscous_friction[at]:.2f} N")

# %% [markdown]
# The ring is at rest, so the film makes hardly any pressure of its own: it passes on that of the gas at its edges, and that carries about half of the load. The asperities carry the rest, *whatever* their number, size and height. Rougher surfaces are further apart; nothing else changes. The shear strength therefore goes through one to one, and the tension matters because it is load that no gas holds up.
#
# Away from TDC it is different: there roughness and oil decide how much the film carries ([a friction band](friction-band.md)).

# The coefficient at TDC, with the lowest and the highest value of each input:

# %%
for i in order[::-1]:
    print(f"{inputs[i][1]:32s} {at_tdc[1 + 2 * i]:.4f} ... {at_tdc[2 + 2 * i]:.4f}")
print(f"{'unchanged':32s} {at_tdc[0]:.4f}")

# %% [markdown]
# A one-at-a-time sensitivity does not show how inputs act together. For that there are Sobol indices: a [study](../manual/study.md) with `indices = "first-and-total"`, as `cases/studies/new_ring_uncertainty.toml`.
