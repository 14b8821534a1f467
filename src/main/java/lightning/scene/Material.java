package lightning.scene;

import java.util.Optional;
import lightning.math.Rgb;

/**
 * How a surface answers light (paper §2.2). All colours are linear.
 *
 * @param name       unique among the materials
 * @param ambient    k<sub>ambient</sub>, also what the surface emits; ≥ 0
 * @param diffuse    k<sub>diffuse</sub>, 0…1, multiplied by the texture where there is one
 * @param specular   k<sub>specular</sub>, 0…1
 * @param shininess  the exponent of the highlight, ≥ 0
 * @param reflective k<sub>reflect</sub> per channel, 0…1
 * @param texture    the picture on the surface
 */
public record Material(String name, Rgb ambient, Rgb diffuse, Rgb specular, double shininess, Rgb reflective,
        Optional<TextureMap> texture) {

    /** What a shape without a material gets: plain grey. */
    public static final Material DEFAULT =
            new Material("default", Rgb.BLACK, Rgb.grey(0.8), Rgb.BLACK, 16, Rgb.BLACK, Optional.empty());

    public Material {
        Limits.name(name);
        Limits.range("ambient", ambient, Limits.MAX_EMISSION);
        Limits.range("diffuse", diffuse, 1);
        Limits.range("specular", specular, 1);
        Limits.range("shininess", shininess, 0, Limits.MAX_SHININESS);
        Limits.range("reflective", reflective, 1);
    }

    public Material withAmbient(Rgb v) {
        return new Material(name, v, diffuse, specular, shininess, reflective, texture);
    }

    public Material withDiffuse(Rgb v) {
        return new Material(name, ambient, v, specular, shininess, reflective, texture);
    }

    public Material withSpecular(Rgb v) {
        return new Material(name, ambient, diffuse, v, shininess, reflective, texture);
    }

    public Material withShininess(double v) {
        return new Material(name, ambient, diffuse, specular, v, reflective, texture);
    }

    public Material withReflective(Rgb v) {
        return new Material(name, ambient, diffuse, specular, shininess, v, texture);
    }

    public Material withTexture(Optional<TextureMap> v) {
        return new Material(name, ambient, diffuse, specular, shininess, reflective, v);
    }
}
