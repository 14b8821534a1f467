package lightning.render.trace;

import lightning.base.math.Rgb;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.material.Material;

/**
 * Colors of an opaque principled material at any metalness, as floats of the lighting equation. At the material's own metalness they are those
 * of {@link MaterialTable}.
 */
public record PrincipledColors(Material material) {

    /** Returns one channel of k<sub>diffuse</sub> without the texture: base·(1 − metalness), less what passes a frosted one. */
    public float diffuse(int channel, double metalness) {
        return (float) (channel(material.base(), channel) * ((1 - metalness) * body(material)));
    }

    /** Returns the share of light that enters a material and does not pass it: 1 unless it is frosted. */
    static double body(Material material) {
        return material.isFrosted() ? 1 - material.transmission().color().max() : 1;
    }

    /** Returns one channel of the part of F0 that no texture multiplies: tint·(1 − metalness)·f0. */
    public float specular(int channel, double metalness) {
        return (float) (channel(material.specularTint(), channel) * ((1 - metalness) * material.f0()));
    }

    /** Returns one channel of the part of F0 that the texture multiplies: base·metalness. */
    public float metalF0(int channel, double metalness) {
        return (float) (channel(material.base(), channel) * metalness);
    }

    /**
     * Returns one channel of the mean of F0² over the metal and the nonmetal part: light that is scattered several times stays in its part.
     *
     * @param texel color of the texture
     */
    public float square(int channel, double metalness, float texel) {
        double metal = channel(material.base(), channel) * texel;
        double nonmetal = channel(material.specularTint(), channel) * material.f0();
        return (float) (metalness * (metal * metal) + (1 - metalness) * (nonmetal * nonmetal));
    }

    /** Returns one channel of that mean at a surface. */
    public float square(int channel, SurfacePoint at) {
        float[] map = at.maps().get(ColumnGroup.METALNESS_TEXEL);
        return square(channel, map == null ? material.metalness() : material.mappedMetalness(map[0]), at.texel()[channel]);
    }

    private static double channel(Rgb color, int channel) {
        return channel == 0 ? color.r() : channel == 1 ? color.g() : color.b();
    }
}
