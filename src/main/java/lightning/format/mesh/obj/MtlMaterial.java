package lightning.format.mesh.obj;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;

/**
 * Material of an MTL file.
 *
 * @param name name in the file
 * @param illumination illum, which selects the applicable parameters
 * @param diffuse Kd, unmodified, as are the other colors
 * @param specular Ks
 * @param emission Ke
 * @param shininess Ns, the exponent of Phong's highlight; empty if absent
 * @param opacity d, 1 for opaque
 * @param filter Tf, filter color of transmitted light
 * @param ior Ni, index of refraction
 * @param texture path of the diffuse image, as written
 * @param emissionMap path of the image that multiplies the emission, as written
 * @param cutout path of the opacity map, as written
 */
public record MtlMaterial(String name, IlluminationModel illumination, Rgb diffuse, Rgb specular, Rgb emission, OptionalDouble shininess,
        double opacity, Rgb filter, double ior, Optional<String> texture, Optional<String> emissionMap, Optional<String> cutout) {
    /**
     * Minimum exponent: smaller ones give a lobe wider than the diffuse term; exporters write 0 for surfaces without a
     * highlight.
     */
    private static final double MIN_SHININESS = 1;

    /** Returns whether lights create highlights: the model has them, and the exponent is large enough. */
    public boolean hasHighlights() {
        return illumination.hasHighlights() && !(shininess.isPresent() && shininess.getAsDouble() < MIN_SHININESS);
    }
}
