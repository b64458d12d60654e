# %% [markdown]
# # What moves the friction coefficient at TDC?
#
# At firing top dead centre (TDC) the ring rests under high gas pressure, with little film left. The friction coefficient $\mu=f_t/W$ there decides the wear near the top of the stroke. Which input changes it most?
#
# **The case:** the new ring of styles2014, 1500 rpm, 120 °C. Its cylinder pressure is SYNTHETIC. **The ranges** below are ASSUMED, not measured.

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
# The friction coefficient at 0 degrees, and its highest value near firing TDC:

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
# *Friction coefficient with the lowest and the highest value of each input. The line is the unchanged case.*
#
# One input has by far the largest effect. The load that asperities carry explains it:

# %%
at = np.argmin(np.abs(batch[0].crank_angle))
now = batch[0]
print(f"load {now.applied_load[at]:.0f} N")
print(f"  carried by asperities {100 * now.asperity_load[at] / now.applied_load[at]:.1f} %")
print(f"  carried by the film   {100 * now.hydrodynamic_load[at] / now.applied_load[at]:.1f} %")
print(f"friction of asperities {now.boundary_friction[at]:.1f} N, of the oil {now.viscous_friction[at]:.2f} N")

# %% [markdown]
# A film at rest passes on the pressure of the gas, which carries about half of the load. The asperities carry the rest, *whatever* their number, size and height. The shear strength therefore acts one to one, and the tension because no gas carries it.
#
# Away from TDC roughness and oil decide how much the film carries ([a friction band](friction-band.md)).

# The coefficient at TDC, with the lowest and the highest value of each input:

# %%
for i in order[::-1]:
    print(f"{inputs[i][1]:32s} {at_tdc[1 + 2 * i]:.4f} ... {at_tdc[2 + 2 * i]:.4f}")
print(f"{'unchanged':32s} {at_tdc[0]:.4f}")

# %% [markdown]
# Sobol indices show how inputs act together: a [study](../manual/study.md) with `indices = "first-and-total"`, as `cases/studies/new_ring_uncertainty.toml`.
