package lightning.image;

import java.awt.image.BufferedImage;

/** Display pixels read from a file. */
public final class Pixels {

    private Pixels() {}

    /** The film whose values are the linear ones of the picture's 8-bit sRGB codes. */
    static Film toFilm(BufferedImage image) {
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

    /** Gives pixel (x, y) of a film the linear values of a display colour 0x--RRGGBB. */
    static void set(Film film, int x, int y, int rgb) {
        int tile = film.tileOf(x, y);
        int pixel = Film.pixelInTile(x, y);
        film.red(tile)[pixel] = Srgb.linear(rgb >> 16 & 0xFF);
        film.green(tile)[pixel] = Srgb.linear(rgb >> 8 & 0xFF);
        film.blue(tile)[pixel] = Srgb.linear(rgb & 0xFF);
    }
}
