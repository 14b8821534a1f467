package lightning.format.mesh.obj;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;

/**
 * A material of an MTL file.
 *
 * @param name         as the file writes it
 * @param illumination illum, which of the other numbers act and how
 * @param diffuse      Kd, as written; the same of all colors
 * @param specular     Ks
 * @param emission     Ke
 * @param shininess    Ns, the exponent of Phong's highlight; empty where the file does not say it
 * @param opacity      d: how much of it is there, 1 is all
 * @param filter       Tf, what is seen through it is multiplied by
 * @param ior          Ni, the index of refraction
 * @param texture      the picture of the diffuse color, as written
 * @param cutout       the picture of what is there, as written
 */
public record MtlMaterial(String name, IlluminationModel illumination, Rgb diffuse, Rgb specular, Rgb emission, OptionalDouble shininess,
        double opacity, Rgb filter, double ior, Optional<String> texture, Optional<String> cutout) {
    /** A lobe of a smaller exponent is wider than the diffuse light; exporters write 0 for a surface without a highlight. */
    private static final double MIN_SHININESS = 1;

    /** Whether lights leave a highlight: the model has one, and its exponent makes one. */
    public boolean hasHighlights() {
        return illumination.hasHighlights() && !(shininess.isPresent() && shininess.getAsDouble() < MIN_SHININESS);
    }
}
