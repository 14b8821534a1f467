package lightning.editor.window.traced;

import lightning.base.text.Messages;
import lightning.render.image.FalseColor;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Values of a pixel: linear red, green and blue, display values, and stops from middle gray. */
final class PixelValues {
    private PixelValues() {}

    static String text(Film film, ViewTransform view, int x, int y) {
        if (x >= film.width() || y >= film.height()) {
            return "";
        }
        float red = film.red(x, y);
        float green = film.green(x, y);
        float blue = film.blue(x, y);
        int packed = view.forOutput().pack(red, green, blue);
        double luminance = (0.2126 * red + 0.7152 * green + 0.0722 * blue) * view.gain();
        String stops =
                luminance > 0
                        ? String.format(Messages.locale(), Messages.tr("%+.1f stops"),
                                Math.log(luminance / FalseColor.MIDDLE_GRAY) / Math.log(2))
                        : "black";
        return String.format(Messages.locale(), "%.3f %.3f %.3f → %d %d %d  %s", red, green, blue, packed >> 16 & 0xFF, packed >> 8 & 0xFF,
                packed & 0xFF, stops);
    }
}
