package lightning.format.nff;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.node.Mesh;

/**
 * Content of an NFF file. Shapes reference their fill by its index in {@code fills}; −1 if none precedes them.
 *
 * @param background background color
 * @param fills unique fills, in order of first occurrence
 * @param meshes polygons of one fill each, and patches of one fill each
 */
public record NffFile(Optional<View> view, Rgb background, List<Light> lights, List<Fill> fills, List<NffSolid> solids,
        List<Surface> meshes) {

    /**
     * Camera.
     *
     * @param angle vertical field of view in degrees
     * @param width pixels; 0 if the file has no resolution
     * @param height pixels; 0 if the file has no resolution
     */
    public record View(Vec3 from, Vec3 at, Vec3 up, double angle, int width, int height) {}

    /** Point light without falloff; the color is optional. */
    public record Light(Vec3 position, Optional<Rgb> color) {}

    /**
     * Surface properties.
     *
     * @param diffuse Kd, a factor of the color
     * @param specular Ks, of highlights and reflections
     * @param shininess exponent of Phong's highlight
     * @param transmittance T, transmitted share of light
     * @param ior index of refraction
     */
    public record Fill(Rgb color, double diffuse, double specular, double shininess, double transmittance, double ior) {}

    /**
     * Flat polygons, or smooth patches.
     *
     * @param name unique in the file, printable on one line
     */
    public record Surface(int fill, String name, Mesh mesh) {}
}
