"""A thin leaf for Mitsuba 3: the BSDF "bilambertian".

Mitsuba itself has no surface that transmits light diffusely. This one reflects the share
`reflectance` and transmits the share `transmittance` of the light that falls on either side, both
as Lambert's law has it: the leaf of canopy models (RAMI; Eradiate's plugin of the same name and
parameters). Call register() after the variant is set and before a scene is loaded.
"""

import drjit as dr
import mitsuba as mi


def _bsdf_class():
    """The class for the variant that is set: its base differs from variant to variant."""

    class Bilambertian(mi.BSDF):
        def __init__(self, props):
            mi.BSDF.__init__(self, props)
            self.reflectance = self._texture(props, "reflectance")
            self.transmittance = self._texture(props, "transmittance")
            sides = mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
            self.m_components = [
                mi.BSDFFlags.DiffuseReflection | sides,
                mi.BSDFFlags.DiffuseTransmission | sides,
            ]
            self.m_flags = self.m_components[0] | self.m_components[1]

        @staticmethod
        def _texture(props, name):
            if hasattr(props, "get_texture"):
                return props.get_texture(name, 0.5)
            return props[name]  # before Mitsuba 3.7 it is a texture already

        def _wanted(self, ctx):
            """Which of reflection and transmission the caller asks for."""
            return (
                ctx.is_enabled(mi.BSDFFlags.DiffuseReflection, 0),
                ctx.is_enabled(mi.BSDFFlags.DiffuseTransmission, 1),
            )

        def _shares(self, ctx, si, active):
            """Reflectance, transmittance, and the probability to follow the reflected light."""
            reflects, transmits = self._wanted(ctx)
            r = self.reflectance.eval(si, active) if reflects else mi.Spectrum(0.0)
            t = self.transmittance.eval(si, active) if transmits else mi.Spectrum(0.0)
            mean_r, mean_t = dr.mean(r), dr.mean(t)
            both = mean_r + mean_t
            return r, t, dr.select(both > 0.0, mean_r / dr.maximum(both, 1e-9), 0.5)

        def sample(self, ctx, si, sample1, sample2, active=True):
            r, t, chance = self._shares(ctx, si, active)
            cos_i = mi.Frame3f.cos_theta(si.wi)
            active = active & (cos_i != 0.0)
            reflected = sample1 < chance
            wo = mi.warp.square_to_cosine_hemisphere(sample2)
            density = mi.warp.square_to_cosine_hemisphere_pdf(wo)
            stays = reflected == (cos_i > 0.0)
            wo.z = dr.select(stays, wo.z, -wo.z)
            bs = mi.BSDFSample3f()
            bs.wo = wo
            bs.pdf = dr.select(active, density * dr.select(reflected, chance, 1.0 - chance), 0.0)
            bs.eta = 1.0
            bs.sampled_component = dr.select(reflected, mi.UInt32(0), mi.UInt32(1))
            bs.sampled_type = dr.select(
                reflected,
                mi.UInt32(int(mi.BSDFFlags.DiffuseReflection)),
                mi.UInt32(int(mi.BSDFFlags.DiffuseTransmission)),
            )
            weight = dr.select(
                reflected, r / dr.maximum(chance, 1e-9), t / dr.maximum(1.0 - chance, 1e-9)
            )
            return bs, weight & (active & (bs.pdf > 0.0))

        def eval_pdf(self, ctx, si, wo, active=True):
            r, t, chance = self._shares(ctx, si, active)
            cos_i, cos_o = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
            active = active & (cos_i != 0.0) & (cos_o != 0.0)
            reflected = cos_i * cos_o > 0.0
            lambert = dr.abs(cos_o) * dr.inv_pi
            value = dr.select(reflected, r, t) * lambert
            density = lambert * dr.select(reflected, chance, 1.0 - chance)
            return value & active, dr.select(active, density, 0.0)

        def eval(self, ctx, si, wo, active=True):
            return self.eval_pdf(ctx, si, wo, active)[0]

        def pdf(self, ctx, si, wo, active=True):
            return self.eval_pdf(ctx, si, wo, active)[1]

        def eval_diffuse_reflectance(self, si, active=True):
            return self.reflectance.eval(si, active)

        def traverse(self, callback):
            for name in ("reflectance", "transmittance"):
                if hasattr(callback, "put"):
                    callback.put(name, getattr(self, name), mi.ParamFlags.Differentiable)
                else:
                    callback.put_object(name, getattr(self, name), mi.ParamFlags.Differentiable)

        def to_string(self):
            both = f"reflectance={self.reflectance}, transmittance={self.transmittance}"
            return f"Bilambertian[{both}]"

    return Bilambertian


def register():
    """Makes `<bsdf type="bilambertian">` known to the variant that is set."""
    bsdf = _bsdf_class()
    mi.register_bsdf("bilambertian", lambda props: bsdf(props))
