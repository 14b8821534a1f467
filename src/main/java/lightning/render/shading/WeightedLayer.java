package lightning.render.shading;

/**
 * A layer of finished contributions, weight and falloff multiplied in, which are summed as they are. Subclasses define how
 * contributions are computed and updated.
 */
public abstract non-sealed class WeightedLayer implements LightLayer {
    /** Diffuse contributions: red, green, blue columns; null where no row is lit. */
    public final float[][] diffuse;
    /** Specular contributions; null where no row is lit or none is specular. */
    public final float[][] specular;
    /** What metallic materials send besides; null where no row is lit or none is metallic. */
    public final float[][] grazing;

    protected WeightedLayer(float[][] diffuse, float[][] specular, float[][] grazing) {
        this.diffuse = diffuse;
        this.specular = specular;
        this.grazing = grazing;
    }
}
