package lightning.render.shading;

import lightning.render.trace.SurfacePoint;

/** How the light of a point is shared between what its surface scatters, what it mirrors and what is seen through it. */
public final class SurfaceShare {
    private final SurfacePoint at;
    private final float mirrored;
    private final float[] tint = {1, 1, 1};

    public SurfaceShare(SurfacePoint at) {
        this.at = at;
        mirrored = at.behind() == null ? 0 : at.share();
        if (at.behind() != null) {
            ClearSums.tint(at.behind().clarity(), at.behind().inside(), tint);
        }
    }

    /** Which part of the light a clear surface mirrors for its angle alone; 0 of an opaque one. */
    public float fresnel() {
        return mirrored;
    }

    /** What is left in a channel after a way inside, 1 where there was none. */
    public float left(int c) {
        return tint[c];
    }

    /** The factor of what the surface scatters and emits. */
    public float body(float kr, int c) {
        return at.behind() == null ? 1 - kr : (1 - mirror(kr)) * ClearSums.body(at.behind().clarity()) * tint[c];
    }

    /** The factor of what the mirrored ray brings. */
    public float mirrored(float kr, int c) {
        return at.behind() == null ? kr : mirror(kr) * tint[c];
    }

    /** The factor of what the refracted ray brings. */
    public float refracted(float kr, int c) {
        return at.behind() == null ? 0 : (1 - mirror(kr)) * ClearSums.channel(at.behind().clarity().clear(), c) * tint[c];
    }

    private float mirror(float kr) {
        return kr + (1 - kr) * mirrored;
    }

    /** One channel of the colour of a clear surface, as {@link LightingEquation} has it. */
    float color(int c, float ka, float ambience, float kd, float diffuse, float ks, float specular, float grazing, float kr,
            float mirroredColor, float refractedColor) {
        return LightingEquation.clearColor(ka, ambience, kd, diffuse, ks, specular, grazing, kr, mirroredColor,
                ClearSums.body(at.behind().clarity()), mirrored, ClearSums.channel(at.behind().clarity().clear(), c), refractedColor,
                tint[c]);
    }
}
