package lightning.render.image;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import lightning.base.math.SrgbCurve;

/** Converts image files with display codes to films. */
public final class DisplayPixels {

    private DisplayPixels() {}

    private static final double MAX_16 = 0xFFFF;

    /** Returns a film with the linear values of the image's sRGB codes, 8 or 16 bits. */
    public static Film toFilm(BufferedImage image) {
        if (image.getSampleModel().getDataType() == DataBuffer.TYPE_USHORT && image.getColorModel() instanceof ComponentColorModel) {
            return toFilm16(image.getRaster());
        }
        int width = image.getWidth();
        int height = image.getHeight();
        Film film = Film.black(width, height);
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            image.getRGB(0, y, width, 1, row, 0, width);
            for (int x = 0; x < width; x++) {
                set(film, x, y, row[x]);
            }
        }
        return film;
    }

    private static Film toFilm16(Raster raster) {
        Film film = Film.black(raster.getWidth(), raster.getHeight());
        // Gray is used for all three channels; a channel after the colors is alpha.
        int step = raster.getNumBands() < 3 ? 0 : 1;
        int[] row = new int[raster.getWidth() * raster.getNumBands()];
        for (int y = 0; y < film.height(); y++) {
            raster.getPixels(0, y, film.width(), 1, row);
            for (int x = 0; x < film.width(); x++) {
                int at = x * raster.getNumBands();
                int tile = film.tileOf(x, y);
                int pixel = Film.pixelInTile(x, y);
                film.red(tile)[pixel] = (float) SrgbCurve.toLinear(row[at] / MAX_16);
                film.green(tile)[pixel] = (float) SrgbCurve.toLinear(row[at + step] / MAX_16);
                film.blue(tile)[pixel] = (float) SrgbCurve.toLinear(row[at + 2 * step] / MAX_16);
            }
        }
        return film;
    }

    /** Sets pixel (x, y) of a film to the linear values of a display color 0x--RRGGBB. */
    static void set(Film film, int x, int y, int rgb) {
        int tile = film.tileOf(x, y);
        int pixel = Film.pixelInTile(x, y);
        film.red(tile)[pixel] = Srgb.linear(rgb >> 16 & 0xFF);
        film.green(tile)[pixel] = Srgb.linear(rgb >> 8 & 0xFF);
        film.blue(tile)[pixel] = Srgb.linear(rgb & 0xFF);
    }
}
