package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Tests visibility, lighting and reflections through cutouts, in scenes with known colors. */
class CutoutImageTest {
    private static final Rgb BLUE = new Rgb(0, 0, 1);
    /** Opaque in the left half of a surface, transparent in the right one. */
    private static final TextureMap LEFT = new TextureMap("left.png", 1, 1, new Texture(2, 1, new float[] {1, 1, 1, 0, 0, 0}));
    private static final TextureMap NOTHING = new TextureMap("nothing.png", 1, 1, new Texture(1, 1, new float[3]));

    private static Material cut(String name, TextureMap map) {
        return glow(name, new Rgb(1, 0, 0)).withCutout(AlphaCutout.NONE.withMap(Optional.of(map)));
    }

    private static Material glow(String name, Rgb color) {
        return Material.of(name).withAmbient(color).withDiffuse(Rgb.BLACK);
    }

    private static Shape shape(Solid solid, String name, String material, Vec3 at, double size) {
        return new Shape(solid, name, material, new Placement(at, Vec3.ZERO, new Vec3(size, size, size)));
    }

    /** View from straight above, two pixels wide; +x is right, and distant shapes are small. */
    private static Scene above(List<Material> materials, List<Shape> shapes, List<Light> lights) {
        return new Scene(new PictureSettings(2, 1, 3), new Camera(new Vec3(0, 10, 0), Vec3.ZERO, new Vec3(0, 0, -1), 10),
                new World(1, BLUE),
                materials,
                List.copyOf(shapes), lights);
    }

    private static float[] color(Film film, int x) {
        return new float[] {film.red(x, 0), film.green(x, 0), film.blue(x, 0)};
    }

    private static Film trace(Scene scene) {
        return new ReferenceTracer(scene).trace();
    }

    @Test
    void cutSquare_showsBackgroundInHoles() {
        Film film = trace(above(List.of(cut("leaf", LEFT)), List.of(shape(Solid.PLANE, "leaf", "leaf", Vec3.ZERO, 4)), List.of()));
        assertThat(color(film, 0)).containsExactly(1, 0, 0);
        assertThat(color(film, 1)).containsExactly(0, 0, 1);
    }

    @Test
    void zeroCutoff_cutsNothing() {
        Material all = cut("leaf", LEFT).withCutout(new AlphaCutout(Optional.of(LEFT), 0));
        Film film = trace(above(List.of(all), List.of(shape(Solid.PLANE, "leaf", "leaf", Vec3.ZERO, 4)), List.of()));
        assertThat(color(film, 1)).containsExactly(1, 0, 0);
    }

    /** Longitude 0.5 points to +z; the right half of the image is where x is above 0. */
    @Test
    void sphereWithHole_showsInnerBackSide() {
        Scene scene = above(List.of(cut("shell", new TextureMap("ring.png", 1, 1,
                new Texture(1, 2, new float[] {0, 0, 0, 1, 1, 1})))),
                List.of(shape(Solid.SPHERE, "ball", "shell", Vec3.ZERO, 2)), List.of());
        ReferenceTracer tracer = new ReferenceTracer(scene);
        // The upper half is cut out: the lower half is visible from inside.
        assertThat(tracer.pixel(0, 0)).containsExactly(1, 0, 0);
        Scene none = above(List.of(cut("shell", NOTHING)), List.of(shape(Solid.SPHERE, "ball", "shell", Vec3.ZERO, 2)), List.of());
        assertThat(new ReferenceTracer(none).pixel(0, 0)).containsExactly(0, 0, 1);
    }

    private static Scene shadowed(TextureMap map) {
        Material floor = Material.of("floor").withDiffuse(Rgb.WHITE);
        return above(List.of(cut("leaf", map), floor), List.of(shape(Solid.PLANE, "floor", "floor", Vec3.ZERO, 20),
                shape(Solid.PLANE, "leaf", "leaf", new Vec3(0, 20, 0), 20)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0))));
    }

    @Test
    void shadowRays_passOnlyThroughHoles() {
        Film film = trace(shadowed(LEFT));
        assertThat(color(film, 0)).containsExactly(0, 0, 0);
        assertThat(color(film, 1)).containsExactly(1, 1, 1);
    }

    @Test
    void mirror_showsObjectsBehindHole() {
        Material mirror = glow("mirror", Rgb.BLACK).withReflective(Rgb.WHITE);
        Scene scene = above(List.of(cut("leaf", LEFT), mirror), List.of(shape(Solid.PLANE, "mirror", "mirror", Vec3.ZERO, 20),
                shape(Solid.PLANE, "leaf", "leaf", new Vec3(0, 20, 0), 20)), List.of());
        Film film = trace(scene);
        assertThat(color(film, 0)).containsExactly(1, 0, 0);
        assertThat(color(film, 1)).containsExactly(0, 0, 1);
    }
}
