package lightning.serve;

import lightning.render.image.Film;
import lightning.scene.PictureSettings;

/** Part of a picture in pixels, counted from the upper left. */
record PictureRegion(int x, int y, int width, int height) {
    private static final int LENGTH = 4;

    /** Reads {@code "region": [x, y, width, height]}; all of the picture without it. */
    static PictureRegion of(Fields fields, PictureSettings picture) {
        if (!fields.has("region")) {
            return new PictureRegion(0, 0, picture.width(), picture.height());
        }
        int[] values = fields.integers("region", LENGTH, 0, Integer.MAX_VALUE);
        var region = new PictureRegion(values[0], values[1], values[2], values[3]);
        if (region.width < 1 || region.height < 1 || (long) region.x + region.width > picture.width()
                || (long) region.y + region.height > picture.height()) {
            throw Fields.bad("region", "expected x, y, width and height inside the picture of " + picture.width() + "x" + picture.height());
        }
        return region;
    }

    boolean isAllOf(Film film) {
        return width == film.width() && height == film.height();
    }
}
