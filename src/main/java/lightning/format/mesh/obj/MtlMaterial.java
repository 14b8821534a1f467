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
 * @param texture diffuse image
 * @param emissionMap image that multiplies the emission
 * @param cutout opacity map
 * @param bump map_Bump, bump or norm: a height or normal map
 * @param physical roughness, metalness and coat with their maps, sheen and anisotropy; empty for materials without them
 */
public record MtlMaterial(String name, IlluminationModel illumination, Rgb diffuse, Rgb specular, Rgb emission, OptionalDouble shininess,
        double opacity, Rgb filter, double ior, Optional<MtlImage> texture, Optional<MtlImage> emissionMap,
        Optional<MtlImage> cutout, Optional<MtlImage> bump, Optional<Physical> physical) {
    /**
     * Statements of physically based materials.
     *
     * @param roughness Pr, 0 … 1
     * @param metalness Pm, 0 … 1
     * @param coat Pc, thickness of the clear layer in the statements, which programs use as its share: 0 … 1
     * @param coatRoughness Pcr, 0 … 1
     * @param sheen Ps, share of a white sheen: 0 … 1
     * @param anisotropy aniso, 0 … 1
     * @param anisotropyRotation anisor, in turns: 0 … 1
     * @param roughnessMap map_Pr
     * @param metalnessMap map_Pm
     * @param coatMap map_Pc
     * @param coatRoughnessMap map_Pcr
     */
    public record Physical(double roughness, double metalness, double coat, double coatRoughness, double sheen,
            double anisotropy, double anisotropyRotation,
            Optional<FactorMap> roughnessMap,
            Optional<FactorMap> metalnessMap, Optional<FactorMap> coatMap, Optional<FactorMap> coatRoughnessMap) {
        /** Statements of a material without any. */
        public static final Physical NONE = new Physical(0.5, 0, 0, 0, 0);

        /** Creates statements without maps. */
        public Physical(double roughness, double metalness, double coat, double coatRoughness, double sheen) {
            this(roughness, metalness, coat, coatRoughness, sheen, 0, 0, Optional.empty(), Optional.empty(), Optional.empty(),
                    Optional.empty());
        }
    }

    /**
     * Image of a number.
     *
     * @param factor multiplies the image: the number's own statement; 1 if it is absent or 0, which would hide the image
     */
    public record FactorMap(MtlImage image, double factor) {}

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
