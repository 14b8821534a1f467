package lightning.render.trace;

import lightning.scene.material.Material;

/**
 * Colors of an opaque principled material at any place, as floats of the lighting equation. Without maps they are those of {@link
 * MaterialTable}.
 */
public record PrincipledColors(Material material) {

    /** Returns one channel of k<sub>diffuse</sub> without the texture: base·(1 − metalness), less what passes a frosted one. */
    public float diffuse(int channel, MappedSurface at) {
        return (float) (MappedSurface.channel(material.base(), channel) * ((1 - at.metalness()) * body(material)));
    }

    /** Returns the share of light that enters a material and does not pass it: 1 unless it is frosted. */
    static double body(Material material) {
        return material.isFrosted() ? 1 - material.transmission().color().max() : 1;
    }

    /** Returns one channel of F0. @param texel color of the texture */
    public float f0(int channel, MappedSurface at, float texel) {
        return (float) (MappedSurface.channel(material.base(), channel) * at.metalness()) * texel + at.specular(channel);
    }

    /**
     * Returns one channel of the mean of F0² over the metal and the nonmetal part: light that is scattered several times stays in its part.
     *
     * @param texel color of the texture
     */
    public float square(int channel, MappedSurface at, float texel) {
        double metal = MappedSurface.channel(material.base(), channel) * texel;
        double nonmetal = at.nonmetalF0(channel);
        return (float) (at.metalness() * (metal * metal) + (1 - at.metalness()) * (nonmetal * nonmetal));
    }
}
