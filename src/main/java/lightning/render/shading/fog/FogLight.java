package lightning.render.shading.fog;

import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.scene.light.Light;

/**
 * Light of one light source in the fog of a picture: which samples along the rays of the grid it reaches, and how much of it they scatter
 * toward the camera, for a weight of 1 and white fog. Compared by identity.
 */
public final class FogLight {
    /** Bytes of a ray of the grid: its samples, which of them see the light, and whether any has light. */
    static final int BYTES_PER_RAY = Float.BYTES * FogGrid.SAMPLES + Integer.BYTES + 1;

    private final Light light;
    private final FogMedium medium;
    private final double anisotropy;
    private final float[] depths;
    private final int[] visible;
    private final float[] parts;
    /** True for rays of which any sample has light. */
    private final boolean[] shines;

    /**
     * @param light      light that it was computed for
     * @param anisotropy mean cosine of scattering
     * @param depths     distance of the first surface along each ray: {@code float[rays]}
     * @param visible    samples of each ray that see the light, the lowest bit for the first: {@code int[rays]}
     * @param parts      light of each sample of each ray: {@code float[rays × samples]}

     */
    public FogLight(Light light, FogMedium medium, double anisotropy, float[] depths, int[] visible, float[] parts) {
        this.light = light;
        this.medium = medium;
        this.anisotropy = anisotropy;
        this.depths = depths;
        this.visible = visible;
        this.parts = parts;
        shines = new boolean[visible.length];
        for (int i = 0; i < parts.length; i++) {
            shines[i / FogGrid.SAMPLES] |= parts[i] != 0;
        }
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

    /** Returns whether it was computed for the same arrays of depths. */
    public boolean hasDepths(float[] of) {
        return depths == of;
    }

    /** Returns the samples of each ray that see the light; must not be modified. */
    public int[] visible() {
        return visible;
    }

    /** Returns the light of each sample of each ray; must not be modified. */
    public float[] parts() {
        return parts;
    }

    /** Returns whether any sample of a ray has light. */
    boolean shines(int ray) {
        return shines[ray];
    }

    /** Returns the bytes of the arrays. */
    public long bytes() {
        return 5L * visible.length + 4L * parts.length;
    }
}
