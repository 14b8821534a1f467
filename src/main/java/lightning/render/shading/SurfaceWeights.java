package lightning.render.shading;

import lightning.render.trace.SurfacePoint;

/** How the light of a point is shared between what its surface scatters, what it mirrors and what is seen through it. */
public final class SurfaceWeights {
    private final SurfacePoint hit;
    private final float fresnel;
    private final float[] tint = {1, 1, 1};

    public SurfaceWeights(SurfacePoint hit) {
        this.hit = hit;
        fresnel = hit.backSide() == null ? 0 : hit.reflectance();
        if (hit.backSide() != null) {
            ClearMaterialShader.interiorTint(hit.backSide().transmission(), hit.backSide().insideDistance(), tint);
        }
    }

    /** Which part of the light a clear surface mirrors for its angle alone; 0 of an opaque one. */
    public float fresnel() {
        return fresnel;
    }

    /** What is left in a channel after a way inside, 1 where there was none. */
    public float interiorTint(int c) {
        return tint[c];
    }

    /** The factor of what the surface scatters and emits. */
    public float bodyWeight(float kr, int c) {
        return hit.backSide() == null ? 1 - kr
                : (1 - reflectance(kr)) * ClearMaterialShader.bodyShare(hit.backSide().transmission()) * tint[c];
    }

    /** The factor of what the mirrored ray brings. */
    public float mirrorWeight(float kr, int c) {
        return hit.backSide() == null ? kr : reflectance(kr) * tint[c];
    }

    /** The factor of what the refracted ray brings. */
    public float refractionWeight(float kr, int c) {
        return hit.backSide() == null ? 0
                : (1 - reflectance(kr)) * ClearMaterialShader.channel(hit.backSide().transmission().color(), c) * tint[c];
    }

    private float reflectance(float kr) {
        return kr + (1 - kr) * fresnel;
    }

    /** One channel of the color of a clear surface, as {@link LightingEquation} has it. */
    float color(int c, float ka, float ambience, float kd, float diffuse, float ks, float specular, float grazing, float kr,
            float mirroredColor, float refractedColor) {
        return LightingEquation.clearColor(ka, ambience, kd, diffuse, ks, specular, grazing, kr, mirroredColor,
                ClearMaterialShader.bodyShare(hit.backSide().transmission()), fresnel,
                ClearMaterialShader.channel(hit.backSide().transmission().color(), c), refractedColor,
                tint[c]);
    }
}
