package lightning.render.image;

/** Display codes as pixels of films. */
final class DisplayPixels {

    private DisplayPixels() {}

    /** Sets pixel (x, y) of a film to the linear values of a display color 0x--RRGGBB. */
    static void set(Film film, int x, int y, int rgb) {
        int tile = film.tileOf(x, y);
        int pixel = Film.pixelInTile(x, y);
        film.red(tile)[pixel] = Srgb.linear(rgb >> 16 & 0xFF);
        film.green(tile)[pixel] = Srgb.linear(rgb >> 8 & 0xFF);
        film.blue(tile)[pixel] = Srgb.linear(rgb & 0xFF);
    }
}
