package lightning.format.pov;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.SafeFile;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.picture.PictureFile;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Camera;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Solid;
import lightning.scene.Texture;
import lightning.scene.TextureMap;

/** A scene in POV-Ray's language. */
public final class PovScene {
    /** How many holes one ray may pass: POV-Ray counts them as it counts mirrors. */
    private static final int HOLES = 20;

    private final String text;
    private final List<String> losses;
    private final Map<String, Texture> images;
    private final Map<String, Texture> heights;

    private PovScene(String text, List<String> losses, Map<String, Texture> images, Map<String, Texture> heights) {
        this.text = text;
        this.losses = List.copyOf(losses);
        this.images = images;
        this.heights = heights;
    }

    /**
     * Translates a scene.
     *
     * @param name the beginning of the names of its texture files
     */
    public static PovScene of(Scene scene, String name) {
        List<String> losses = new ArrayList<>();
        Map<String, Texture> images = new LinkedHashMap<>();
        Map<String, Texture> heights = new LinkedHashMap<>();
        var body = new StringBuilder();
        body.append("global_settings {\n  assumed_gamma 1.0\n  max_trace_level ")
                .append(scene.picture().depth() + 1 + (cuts(scene) ? HOLES : 0))
                .append("\n  adc_bailout 0\n  ambient_light rgb ").append(scene.world().ambience()).append("\n}\n");
        body.append("background { ").append(PovText.rgb(scene.world().background())).append(" }\n");
        scene.world().environment().ifPresent(p -> {
            losses.add("the environment is its lamps; the picture of it is looked for as " + p.file());
            // POV-Ray's picture begins at the x axis and runs towards z; ours, a quarter before that, begins in the middle at −z.
            body.append("sky_sphere {\n  pigment { image_map { hdr \"").append(p.file().replaceAll("[\\\\\"]", "\\\\$0"))
                    .append("\" map_type 1 interpolate 2 } }\n  rotate <0, ")
                    .append(scene.world().rotation() - 90).append(", 0>\n  emission rgb ").append(scene.world().intensity())
                    .append("\n}\n");
        });
        body.append(camera(scene));
        var meshes = new PovMesh(scene, losses);
        body.append(meshes.declarations());
        var materials = new PovMaterial(losses);
        for (PlacedShape shape : scene.placedShapes()) {
            String image = shape.material().texture().map(t -> image(images, t, name)).orElse("");
            String mask = shape.material().cutout().cutout().map(t -> image(images, t, name + "-cutout")).orElse("");
            String bumps = shape.material().relief().bump().filter(_ -> shape.material().relief().bumps())
                    .map(t -> image(heights, t, name + "-bump")).orElse("");
            body.append("// ").append(shape.shape().name()).append('\n').append(solid(shape.shape().solid(), meshes)).append("\n  ")
                    .append(materials.text(shape.material(), shape.shape().solid(), image, mask, bumps)).append("\n  ")
                    .append(PovText.matrix(shape.toWorld())).append("\n}\n");
        }
        var lights = new PovLight(Extent.of(scene), losses);
        scene.rig().actingLights().forEach(light -> body.append(lights.text(scene, light)));
        return new PovScene(head(scene, losses) + body, losses, images, heights);
    }

    private static boolean cuts(Scene scene) {
        return scene.materials().stream().anyMatch(m -> m.cutout().cuts());
    }

    private static String head(Scene scene, List<String> losses) {
        var head = new StringBuilder("// For POV-Ray 3.7. Run in this folder: povray +Ithis.pov +W" + scene.picture().width()
                + " +H" + scene.picture().height() + " -A -D\n");
        losses.forEach(loss -> head.append("// Not as in the scene: ").append(loss).append('\n'));
        return head.append("#version 3.7;\n").toString();
    }

    private static String camera(Scene scene) {
        Camera camera = scene.camera();
        Vec3 forward = camera.to().minus(camera.from()).normalized();
        Vec3 right = forward.cross(camera.up().normalized()).normalized();
        Vec3 up = right.cross(forward);
        double half = camera.fov() / 2;
        double distance = 0.5 * Transform.cosDegrees(half) / Transform.sinDegrees(half);
        double aspect = (double) scene.picture().width() / scene.picture().height();
        return "camera {\n  perspective\n  location " + PovText.vector(camera.from()) + "\n  direction "
                + PovText.vector(forward.times(distance)) + "\n  right " + PovText.vector(right.times(aspect)) + "\n  up "
                + PovText.vector(up) + "\n}\n";
    }

    /** A solid, left open for texture and placing. */
    private static String solid(Solid solid, PovMesh meshes) {
        return switch (solid) {
            case Solid.Canonical c -> c.povRay();
            case Solid.Triangles t -> meshes.text(t);
        };
    }

    private static String image(Map<String, Texture> images, TextureMap map, String name) {
        String file = name.replaceAll("[\"\\\\\\p{C}]", "_") + "-" + map.file().replaceAll("[^\\p{Alnum}_-]", "_") + ".png";
        images.put(file, map.image());
        return file;
    }

    /** The file's content. */
    public String text() {
        return text;
    }

    /** What POV-Ray cannot say, or not exactly: one sentence each, the scene's names in it. */
    public List<String> losses() {
        return losses;
    }

    /**
     * Writes the scene, and its textures beside it.
     *
     * @throws IOException if a file cannot be written
     */
    public void write(Path file) throws IOException {
        for (var image : images.entrySet()) {
            PictureFile.write(file.resolveSibling(image.getKey()), film(image.getValue()), ViewTransform.DEFAULT);
        }
        for (var image : heights.entrySet()) {
            // Slopes are differences of neighbours: 8 bits would make steps of them.
            PictureFile.write(file.resolveSibling(image.getKey()), gray(image.getValue()), new ViewTransform(0, DisplayCurve.LINEAR), 16);
        }
        SafeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    /** Of the luminance, which POV-Ray weighs otherwise. */
    private static Film gray(Texture texture) {
        float[] rgb = new float[3 * texture.width() * texture.height()];
        for (int i = 0; i < rgb.length; i++) {
            int x = i / 3 % texture.width();
            int y = i / 3 / texture.width();
            rgb[i] = (float) texture.luminance(x, y, x, y, 0, 0);
        }
        return Film.ofScanlines(texture.width(), texture.height(), rgb);
    }

    private static Film film(Texture texture) {
        float[] rgb = new float[3 * texture.width() * texture.height()];
        for (int i = 0; i < rgb.length; i++) {
            int pixel = i / 3;
            rgb[i] = texture.channel(pixel % texture.width(), pixel / texture.width(), i % 3);
        }
        return Film.ofScanlines(texture.width(), texture.height(), rgb);
    }
}
