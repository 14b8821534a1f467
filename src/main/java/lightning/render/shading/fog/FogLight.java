package lightning.render.shading.fog;

import lightning.render.fog.FogMedium;
import lightning.render.fog.FogPath;
import lightning.scene.light.Light;

/**
 * Light of one light source in the fog of a picture: which samples along the rays of the grid it reaches, and how much of it they scatter
 * toward the camera, for a weight of 1 and white fog. Compared by identity.
 */
public final class FogLight {
    private final Light light;
    private final FogMedium medium;
    private final double anisotropy;
    private final int[] visible;
    private final float[] sums;

    /**
     * @param light      light that it was computed for
     * @param anisotropy mean cosine of scattering
     * @param visible    samples of each ray that see the light, the lowest bit for the first: {@code int[rays]}
     * @param sums       sum of the samples before each place, filtered over neighboring rays: {@code float[rays × (samples + 1)]}
     */
    public FogLight(Light light, FogMedium medium, double anisotropy, int[] visible, float[] sums) {
        this.light = light;
        this.medium = medium;
        this.anisotropy = anisotropy;
        this.visible = visible;
        this.sums = sums;
    }

    /** Returns the light that it was computed for. */
    public Light light() {
        return light;
    }

    /** Returns the fog that it was computed for. */
    public FogMedium medium() {
        return medium;
    }

    public double anisotropy() {
        return anisotropy;
    }

    /** Returns the samples of each ray that see the light; must not be modified. */
    public int[] visible() {
        return visible;
    }

    /** Returns the sums before each {@link FogPath#place} of each ray; must not be modified. */
    public float[] sums() {
        return sums;
    }

    /** Returns the bytes of the arrays. */
    public long bytes() {
        return 4L * visible.length + 4L * sums.length;
    }
}
