package lightning.editor.window.welcome;

import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;

/**
 * Program that renders the thumbnails of the welcome page: those of the named scenes, or all of them. Each is traced at twice its size, in
 * both directions.
 */
final class SceneThumbnails {
    private static final Path FOLDER = Path.of("src", "main", "resources", "lightning", "editor", "window", "welcome");
    private static final int SCALE = 2;
    private static final float QUALITY = 0.85f;

    private SceneThumbnails() {}

    /**
     * Run by
     * {@code mvn -q test-compile exec:exec@test-main -Dlightning.main="lightning.editor.window.welcome.SceneThumbnails [scene...]"}.
     */
    public static void main(String[] args) throws IOException, JenException {
        try (var workers = new WorkerPool(WorkerPool.processorCount())) {
            for (ShippedScene shipped : ShippedScene.ALL) {
                if (args.length == 0 || List.of(args).contains(shipped.name())) {
                    Scene scene = JenReader.read(shipped.file()).scene();
                    Scene resized = scene.withPicture(scene.picture().withSize(ShippedScene.THUMBNAIL_WIDTH * SCALE,
                            ShippedScene.THUMBNAIL_HEIGHT * SCALE));
                    Film film = new TraditionalTracer(resized).trace(workers, Progress.NONE).film();
                    write(FOLDER.resolve(shipped.name() + ".jpg"), reduced(film, SceneView.of(scene).toPixels(film)));
                }
            }
        }
    }

    private static BufferedImage reduced(Film film, int[] pixels) {
        var large = new BufferedImage(film.width(), film.height(), BufferedImage.TYPE_INT_RGB);
        large.setRGB(0, 0, film.width(), film.height(), pixels, 0, film.width());
        var small = new BufferedImage(film.width() / SCALE, film.height() / SCALE, BufferedImage.TYPE_INT_RGB);
        var graphics = small.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        graphics.drawImage(large, 0, 0, small.getWidth(), small.getHeight(), null);
        graphics.dispose();
        return small;
    }

    private static void write(Path file, BufferedImage image) throws IOException {
        var writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ImageWriteParam settings = writer.getDefaultWriteParam();
        settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        settings.setCompressionQuality(QUALITY);
        try (var out = ImageIO.createImageOutputStream(Files.newOutputStream(file))) {
            writer.setOutput(out);
            writer.write(null, new IIOImage(image, null, null), settings);
        } finally {
            writer.dispose();
        }
    }
}
