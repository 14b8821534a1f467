package lightning.render.trace;

import lightning.base.math.Rgb;
import lightning.scene.material.Material;

/**
 * Colors of an opaque principled material at any metalness, as floats of the lighting equation. At the material's own metalness they are those
 * of {@link MaterialTable}.
 */
public record PrincipledColors(Material material) {

    /** Returns one channel of k<sub>diffuse</sub> without the texture: base·(1 − metalness). */
    public float diffuse(int channel, double metalness) {
        return (float) (channel(material.base(), channel) * (1 - metalness));
    }

    /** Returns one channel of the part of F0 that no texture multiplies: tint·(1 − metalness)·f0. */
    public float specular(int channel, double metalness) {
        return (float) (channel(material.specularTint(), channel) * ((1 - metalness) * material.f0()));
    }

    /** Returns one channel of the part of F0 that the texture multiplies: base·metalness. */
    public float metalF0(int channel, double metalness) {
        return (float) (channel(material.base(), channel) * metalness);
    }

    private static double channel(Rgb color, int channel) {
        return channel == 0 ? color.r() : channel == 1 ? color.g() : color.b();
    }
}
