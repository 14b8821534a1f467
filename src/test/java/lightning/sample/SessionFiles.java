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
import lightning.format.jen.JenWriter;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import net.jqwik.api.sessions.JqwikSession;

/**
 * Writes arbitrary sessions as files, so that another build of the program can go through them: see {@code benchmarks/films}.
 * A session is a folder, the scenes in it are numbered; the same number of sessions is the same sessions.
 */
public final class SessionFiles {
    private static final int EDGE_CASES = 1000;

    private SessionFiles() {}

    /** @param args the folder, not yet there, and how many sessions */
    public static void main(String[] args) throws Throwable {
        JqwikSession.run(() -> write(Path.of(args[0]), Integer.parseInt(args[1])));
    }

    private static void write(Path folder, int count) throws IOException {
        var generator = Session.sessions().generator(EDGE_CASES);
        var random = new Random(1998);
        for (int i = 0; i < count; i++) {
            write(Files.createDirectories(folder.resolve(String.format(Locale.ROOT, "%06d", i))), generator.next(random).value().scenes());
        }
    }

    private static void write(Path folder, List<Scene> scenes) throws IOException {
        Map<Texture, String> files = new IdentityHashMap<>();
        for (int k = 0; k < scenes.size(); k++) {
            Scene scene = scenes.get(k).withMaterials(scenes.get(k).materials().stream().map(m -> named(m, files)).toList());
            Files.writeString(folder.resolve(String.format(Locale.ROOT, "%02d.jen", k)), JenWriter.write(scene));
        }
        for (Map.Entry<Texture, String> file : files.entrySet()) {
            ImageIO.write(image(file.getKey()), "png", folder.resolve(file.getValue()).toFile());
        }
    }

    private static Material named(Material material, Map<Texture, String> files) {
        return material.withTexture(material.texture().map(t -> new TextureMap(
                files.computeIfAbsent(t.image(), _ -> "texture-" + files.size() + ".png"), t.repeatU(), t.repeatV(), t.image())));
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
