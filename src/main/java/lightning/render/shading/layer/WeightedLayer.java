package lightning.render.shading.layer;

/**
 * Layer of finished contributions, which include weight and falloff and are summed unchanged. Subclasses define how contributions
 * are computed and updated.
 */
public abstract non-sealed class WeightedLayer implements LightLayer {
    /** Diffuse contributions: red, green, blue columns; null if no row is lit. */
    public final float[][] diffuse;
    /** Specular contributions; null if no row is lit or none is specular. */
    public final float[][] specular;
    /** Grazing contributions of metallic materials; null if no row is lit or none is metallic. */
    public final float[][] grazing;

    protected WeightedLayer(float[][] diffuse, float[][] specular, float[][] grazing) {
        this.diffuse = diffuse;
        this.specular = specular;
        this.grazing = grazing;
    }
}
