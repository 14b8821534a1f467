package lightning.scene;

import java.util.Optional;
import lightning.math.Rgb;

/**
 * How a surface answers light (paper §2.2). All colours are linear; {@link MaterialAttribute} tells the ranges.
 *
 * @param name       unique among the materials
 * @param ambient    k<sub>ambient</sub>, also what the surface emits
 * @param diffuse    k<sub>diffuse</sub>, multiplied by the texture where there is one
 * @param specular   k<sub>specular</sub>
 * @param shininess  the exponent of the highlight
 * @param reflective k<sub>reflect</sub> per channel
 * @param texture    the picture on the surface
 */
public record Material(String name, Rgb ambient, Rgb diffuse, Rgb specular, double shininess, Rgb reflective,
        Optional<TextureMap> texture) {

    /** What a shape without a material gets: plain grey. */
    public static final Material DEFAULT = of("default");

    public Material {
        Limits.name(name);
        MaterialAttribute.AMBIENT.check(ambient);
        MaterialAttribute.DIFFUSE.check(diffuse);
        MaterialAttribute.SPECULAR.check(specular);
        MaterialAttribute.SHININESS.check(shininess);
        MaterialAttribute.REFLECTIVE.check(reflective);
    }

    /** A material of which nothing else was said. */
    public static Material of(String name) {
        return new Material(name, MaterialAttribute.AMBIENT.initial(), MaterialAttribute.DIFFUSE.initial(),
                MaterialAttribute.SPECULAR.initial(), MaterialAttribute.SHININESS.initial(),
                MaterialAttribute.REFLECTIVE.initial(), MaterialAttribute.TEXTURE.initial());
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
