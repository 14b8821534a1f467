package lightning.render.shading.layer;

import org.jspecify.annotations.Nullable;

/**
 * Layer of finished contributions, which include weight and falloff and are summed unchanged. Subclasses define how contributions
 * are computed and updated.
 */
public abstract non-sealed class WeightedLayer implements LightLayer {
    /** Diffuse contributions: red, green, blue columns; null if no row is lit. */
    public final float @Nullable [][] diffuse;
    /** Specular contributions; null if no row is lit or none is specular. */
    public final float @Nullable [][] specular;
    /** Grazing contributions of metallic materials; null if no row is lit or none is metallic. */
    public final float @Nullable [][] grazing;

    protected WeightedLayer(float @Nullable [][] diffuse, float @Nullable [][] specular, float @Nullable [][] grazing) {
        this.diffuse = diffuse;
        this.specular = specular;
        this.grazing = grazing;
    }
}
