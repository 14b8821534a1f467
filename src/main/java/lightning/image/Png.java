package lightning.image;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferInt;
import java.awt.image.DataBufferUShort;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** PNG: what is displayed, 8 or 16 bits a channel, without loss. */
final class Png {

    private Png() {}

    static void write(OutputStream out, Film film, ViewTransform view, int bits) throws IOException {
        write(out, bits == Byte.SIZE ? image(film.width(), film.height(), view.toPixels(film)) : deep(film, view));
    }

    private static BufferedImage image(int width, int height, int[] pixels) {
        // Over the pixels themselves: a copy of a large picture takes a GB.
        var model = new DirectColorModel(24, 0xFF0000, 0xFF00, 0xFF);
        var raster = Raster.createPackedRaster(new DataBufferInt(pixels, pixels.length), width, height, width, model.getMasks(), null);
        return new BufferedImage(model, raster, false, null);
    }

    /** 16 bits a channel. */
    private static BufferedImage deep(Film film, ViewTransform view) {
        var model = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE,
                DataBuffer.TYPE_USHORT);
        var raster = model.createCompatibleWritableRaster(film.width(), film.height());
        short[] codes = ((DataBufferUShort) raster.getDataBuffer()).getData();
        for (int y = 0, at = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                view.packDeep(film.red(x, y), film.green(x, y), film.blue(x, y), codes, at);
                at += 3;
            }
        }
        return new BufferedImage(model, raster, false, null);
    }

    private static void write(OutputStream out, BufferedImage image) throws IOException {
        // A stream of our own, because ImageIO would put its cache into a file.
        try (var stream = new MemoryCacheImageOutputStream(out)) {
            if (!ImageIO.write(image, "png", stream)) {
                throw new IOException("this Java has no PNG writer");
            }
        }
    }

    /**
     * Display pixels as a film whose values are the linear ones of the codes. Transparency is ignored.
     *
     * @throws IOException if the file is no PNG, is damaged or is too large; the message does not repeat its name
     */
    static Film read(Path file) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try (var stream = new MemoryCacheImageInputStream(Files.newInputStream(file))) {
            reader.setInput(stream, true, true);
            PictureLimits.check(reader.getWidth(0), reader.getHeight(0));
            return Pixels.toFilm(reader.read(0));
        } catch (RuntimeException e) {
            // The reader answers some damaged files with unchecked exceptions.
            throw new IOException("is no undamaged PNG picture", e);
        } finally {
            reader.dispose();
        }
    }
}
