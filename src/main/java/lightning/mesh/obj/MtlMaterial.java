package lightning.mesh.obj;

import java.util.Optional;
import lightning.math.Rgb;

/**
 * A material of an MTL file.
 *
 * @param name      as the file writes it
 * @param diffuse   Kd, as written; the same of all colours
 * @param specular  Ks
 * @param emission  Ke
 * @param shininess Ns, the exponent of Phong's highlight
 * @param mirrors   whether its model of illumination ({@code illum} 3 and those beyond) has mirrored rays
 * @param texture   the picture of the diffuse colour, as written
 */
public record MtlMaterial(String name, Rgb diffuse, Rgb specular, Rgb emission, double shininess, boolean mirrors,
        Optional<String> texture) {
    static MtlMaterial of(String name) {
        return new MtlMaterial(name, Rgb.grey(0.8), Rgb.BLACK, Rgb.BLACK, 0, false, Optional.empty());
    }
}
