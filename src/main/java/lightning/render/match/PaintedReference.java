package lightning.render.match;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import lightning.render.image.Film;
import org.jspecify.annotations.Nullable;

/**
 * Reference that is painted on a picture: where a brush was, the picture shall change as it says; elsewhere it shall stay.
 */
public final class PaintedReference {
    private PaintedReference() {}

    /**
     * Returns the picture as the brush asks for it; the last dab on a pixel counts. All pixels without paint weigh as much as all with paint, and
     * differences count relative to the picture.
     *
     * @param dabs in the order in which they were painted
     */
    public static ReferenceImage of(Film picture, List<BrushDab> dabs) {
        BrushDab.Wish[] wishes = wishes(picture.width(), picture.height(), dabs);
        float[] rgb = picture.toScanlines();
        float[] weights = new float[wishes.length];
        float[] stays = new float[wishes.length];
        long painted = Arrays.stream(wishes).filter(Objects::nonNull).count();
        Arrays.fill(stays, (float) painted / Math.max(1, wishes.length - painted));
        for (int i = 0; i < wishes.length; i++) {
            BrushDab.Wish wish = wishes[i];
            if (wish != null) {
                stays[i] = 0;
                weights[i] = wish.luminance() * wish.luminance();
                for (int c = 0; c < 3; c++) {
                    rgb[3 * i + c] *= wish.factor(c);
                }
            }
        }
        return new ReferenceImage(Film.ofScanlines(picture.width(), picture.height(), rgb), weights, stays);
    }

    /** Returns what is asked for at each pixel, row by row from the top left; null where nothing is. */
    public static BrushDab.@Nullable Wish[] wishes(int width, int height, List<BrushDab> dabs) {
        BrushDab.@Nullable Wish[] wishes = new BrushDab.Wish[width * height];
        for (BrushDab dab : dabs) {
            int top = (int) Math.clamp(Math.floor(dab.y() - dab.radius()), 0, height);
            int bottom = (int) Math.clamp(Math.ceil(dab.y() + dab.radius()), 0, height);
            int left = (int) Math.clamp(Math.floor(dab.x() - dab.radius()), 0, width);
            int right = (int) Math.clamp(Math.ceil(dab.x() + dab.radius()), 0, width);
            for (int y = top; y < bottom; y++) {
                for (int x = left; x < right; x++) {
                    if (Math.hypot(x + 0.5 - dab.x(), y + 0.5 - dab.y()) <= dab.radius()) {
                        wishes[y * width + x] = dab.wish();
                    }
                }
            }
        }
        return wishes;
    }
}
