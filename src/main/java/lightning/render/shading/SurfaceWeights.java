package lightning.render.shading;

import lightning.render.trace.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** Weights of a surface point's diffuse body, its reflection and its refraction. */
public final class SurfaceWeights {
    /** Null for a surface that is not clear. */
    private final SurfacePoint.@Nullable BackSide side;
    private final float fresnel;
    private final float[] tint = {1, 1, 1};

    public SurfaceWeights(SurfacePoint hit) {
        side = hit.clearSide();
        fresnel = side == null ? 0 : hit.reflectance();
        if (side != null) {
            new InteriorTint(side.transmission()).write(side.insideDistance(), tint);
        }
    }

    /** Returns the Fresnel share that a clear surface mirrors; 0 for an opaque or frosted surface. */
    public float fresnel() {
        return fresnel;
    }

    /** Returns the transmittance of a channel along the path inside a solid; 1 if there was no such path. */
    public float interiorTint(int c) {
        return tint[c];
    }

    /** Returns the factor of emitted light that an image multiplies, as in {@link LightingEquation#addMapped}. */
    public float bodyWeight(float kr, int c) {
        return side == null ? 1 - kr
                : (1 - reflectance(kr)) * ClearMaterialShader.bodyShare(side.transmission()) * tint[c];
    }

    /**
     * Returns what the body sends of a light, multiplied in the order of the {@link LightingEquation}: a product of weights may be so small
     * that it has lost its precision, which a bright light would amplify.
     *
     * @param light light before the weights, kd·Idiff for diffuse light, linear, ≥ 0
     */
    public float body(float light, float kr, int c) {
        return side == null ? light * (1 - kr)
                : light * ((1 - reflectance(kr)) * ClearMaterialShader.bodyShare(side.transmission())) * tint[c];
    }

    /** Returns the part of the mirrored ray, whose color has the channel {@code color}. */
    public float mirrored(float color, float kr, int c) {
        return side == null ? kr * color : reflectance(kr) * color * tint[c];
    }

    /** Returns the part of the refracted ray, whose color has the channel {@code color}; 0 for an opaque or frosted surface. */
    public float refracted(float color, float kr, int c) {
        return side == null ? 0
                : (1 - reflectance(kr)) * ClearMaterialShader.channel(side.transmission().color(), c) * color * tint[c];
    }

    private float reflectance(float kr) {
        return kr + (1 - kr) * fresnel;
    }

    /** Returns one channel of the color of a clear surface by the {@link LightingEquation}. */
    public float color(int c, float emitted, float kd, float diffuse, float ks, float specular, float grazing, float kr,
            float mirroredColor, float refractedColor) {
        assert side != null;
        return LightingEquation.clearColor(emitted, kd, diffuse, ks, specular, grazing, kr, mirroredColor,
                ClearMaterialShader.bodyShare(side.transmission()), fresnel,
                ClearMaterialShader.channel(side.transmission().color(), c), refractedColor,
                tint[c]);
    }
}
