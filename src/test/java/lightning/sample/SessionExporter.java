package lightning.sample;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import javax.imageio.ImageIO;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenWriter;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.material.Material;
import lightning.scene.node.Mesh;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import net.jqwik.api.sessions.JqwikSession;

/**
 * Exporter of arbitrary sessions as files, so that another build of the program can replay them: see {@code benchmarks/films}. A session is
 * a folder with numbered scenes; the sessions are reproducible.
 */
public final class SessionExporter {
    private static final int EDGE_CASES = 1000;
    /** Brightest along the axis. */
    private static final String PROFILE = "TILT=NONE\n1 1 1 3 1 1 2 0 0 0 1 1 1 0 45 90 0 4 2 1\n";

    private SessionExporter() {}

    /** @param args the folder, not yet existing, and the number of sessions */
    public static void main(String[] args) throws Throwable {
        JqwikSession.run(() -> write(Path.of(args[0]), Integer.parseInt(args[1])));
    }

    private static void write(Path folder, int count) throws IOException {
        var generator = EditSession.sessions().generator(EDGE_CASES);
        var random = new Random(1998);
        for (int i = 0; i < count; i++) {
            write(Files.createDirectories(folder.resolve(String.format(Locale.ROOT, "%06d", i))), generator.next(random).value().scenes());
        }
    }

    /** Writes a session into an existing folder: {@code 00.jen} and so on, and the files that the scenes reference. */
    public static void write(Path folder, List<Scene> scenes) throws IOException {
        Map<Texture, String> files = new IdentityHashMap<>();
        for (int k = 0; k < scenes.size(); k++) {
            Scene scene = scenes.get(k).withMaterials(scenes.get(k).materials().stream().map(m -> withTextureFiles(m, files)).toList());
            Files.writeString(folder.resolve(String.format(Locale.ROOT, "%02d.jen", k)), JenWriter.write(scene));
        }
        for (Map.Entry<Texture, String> file : files.entrySet()) {
            ImageIO.write(image(file.getKey()), "png", folder.resolve(file.getValue()).toFile());
        }
        ImageIO.write(image(new Texture(2, 2, new float[] {1, 0.5f, 0, 0, 0.5f, 1, 1, 1, 1, 0.25f, 0, 0.75f})), "png",
                folder.resolve("sample.png").toFile());
        Files.writeString(folder.resolve("sample.ies"), PROFILE);
        ImageFile.write(folder.resolve("sample.hdr"), Film.ofScanlines(2, 1, new float[] {0.5f, 1, 2, 3, 0.25f, 0}),
                ViewTransform.DEFAULT);
        for (Scene scene : scenes) {
            writeMeshes(folder, scene.nodes());
        }
    }

    private static void writeMeshes(Path folder, List<SceneNode> nodes) throws IOException {
        for (SceneNode node : nodes) {
            switch (node) {
                case NodeGroup group -> writeMeshes(folder, group.children());
                case Shape shape -> {
                    if (shape.solid() instanceof Solid.TriangleMesh mesh) {
                        Files.writeString(folder.resolve(mesh.file()), ply(mesh.mesh()));
                    }
                }
            }
        }
    }

    /** Returns its triangles only; one triangle if it has none, which no file may have. */
    private static String ply(Mesh of) {
        Mesh mesh = of.triangleCount() > 0 ? of : new Mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}, null, null, null);
        var text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex ").append(mesh.vertexCount())
                .append("\nproperty float x\nproperty float y\nproperty float z\nelement face ").append(mesh.triangleCount())
                .append("\nproperty list uchar int vertex_indices\nend_header\n");
        for (int v = 0; v < mesh.vertexCount(); v++) {
            text.append(mesh.positions()[3 * v]).append(' ').append(mesh.positions()[3 * v + 1]).append(' ')
                    .append(mesh.positions()[3 * v + 2]).append('\n');
        }
        for (int t = 0; t < mesh.triangleCount(); t++) {
            text.append("3 ").append(mesh.triangles()[3 * t]).append(' ').append(mesh.triangles()[3 * t + 1]).append(' ')
                    .append(mesh.triangles()[3 * t + 2]).append('\n');
        }
        return text.toString();
    }

    private static Material withTextureFiles(Material material, Map<Texture, String> files) {
        return material.withTexture(material.texture().map(
                t -> t.withFile(files.computeIfAbsent(t.image(), _ -> "texture-" + files.size() + ".png"))));
    }

    private static BufferedImage image(Texture texture) {
        var image = new BufferedImage(texture.width(), texture.height(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < texture.height(); y++) {
            for (int x = 0; x < texture.width(); x++) {
                int rgb = 0;
                for (int c = 0; c < 3; c++) {
                    rgb = rgb << 8 | Math.round(255 * texture.channel(x, y, c));
                }
                image.setRGB(x, y, rgb);
            }
        }
        return image;
    }
}
