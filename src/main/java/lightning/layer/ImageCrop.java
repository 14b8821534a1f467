package lightning.layer;

/**
 * Rectangle of an image.
 *
 * @param left first column
 * @param top first line
 * @param right end of the columns, after {@code left}
 * @param bottom end of the lines, after {@code top}
 */
public record ImageCrop(int left, int top, int right, int bottom) {
    int width() {
        return right - left;
    }

    int height() {
        return bottom - top;
    }
}
