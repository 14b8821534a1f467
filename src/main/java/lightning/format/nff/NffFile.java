package lightning.format.nff;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Mesh;

/**
 * What an NFF file holds. Shapes name their fill by its place in {@code fills}; −1 where none stands before them.
 *
 * @param background where a ray meets nothing
 * @param fills      each once, in the order of their first coming
 * @param meshes     polygons of one fill each, and patches of one fill each
 */
public record NffFile(Optional<View> view, Rgb background, List<Light> lights, List<Fill> fills, List<NffSolid> solids,
        List<Surface> meshes) {

    /**
     * Where it is seen from.
     *
     * @param angle  degrees, from the top of the picture to its bottom
     * @param width  pixels; 0 where the file says no resolution, likewise the height
     * @param height pixels
     */
    public record View(Vec3 from, Vec3 at, Vec3 up, double angle, int width, int height) {}

    /** A light in all directions, which does not fall off; it need not say its color. */
    public record Light(Vec3 position, Optional<Rgb> color) {}

    /**
     * What a surface looks like.
     *
     * @param diffuse       Kd, a factor on the color
     * @param specular      Ks, of highlights and of what is mirrored
     * @param shininess         the exponent of Phong's highlight
     * @param transmittance T, how much light goes through
     * @param ior         the index of refraction
     */
    public record Fill(Rgb color, double diffuse, double specular, double shininess, double transmittance, double ior) {}

    /**
     * Polygons, which are flat, or patches, which are smooth.
     *
     * @param name unique in the file, shown in one line
     */
    public record Surface(int fill, String name, Mesh mesh) {}
}
