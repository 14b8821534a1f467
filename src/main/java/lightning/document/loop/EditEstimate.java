package lightning.document.loop;

import java.util.stream.IntStream;
import lightning.render.image.Film;

/**
 * Estimate of an edited scene's picture. It is the last picture, times a ratio, plus light. Both follow from coarse pictures of the scenes
 * before and after the edit, and are interpolated between the centers of their pixels. Where they are equal, the picture stays as it is.
 */
final class EditEstimate {
    /** Ratio and light of each coarse pixel and channel: {@code float[3][pixels]}. */
    private final float[][] ratio;
    private final float[][] added;
    private final Film last;
    private final int coarseWidth;
    private final int coarseHeight;

    private EditEstimate(Film last, Film before, Film after, boolean shapesChange) {
        this.last = last;
        coarseWidth = before.width();
        coarseHeight = before.height();
        ratio = new float[3][coarseWidth * coarseHeight];
        added = new float[3][coarseWidth * coarseHeight];
        for (int y = 0; y < coarseHeight; y++) {
            for (int x = 0; x < coarseWidth; x++) {
                boolean isReplaced = shapesChange && differsNear(before, after, x, y);
                for (int channel = 0; channel < 3; channel++) {
                    setChange(channel, x, y, value(before, channel, x, y), value(after, channel, x, y), isReplaced);
                }
            }
        }
    }

    /**
     * @param last         picture of the scene before the edit
     * @param before       coarse picture of that scene
     * @param after        coarse picture of the edited scene, as large as {@code before}
     * @param shapesChange whether shapes differ; where they do, the coarse picture replaces the last one
     * @return a picture as large as {@code last}
     */
    static Film of(Film last, Film before, Film after, boolean shapesChange) {
        return new EditEstimate(last, before, after, shapesChange).estimate();
    }

    /**
     * Light that goes multiplies the picture, which keeps its details. Light that comes is added: a ratio would multiply neighbors that were
     * lit already. Replaced pixels keep what the picture had beyond the coarse one, such as indirect light.
     */
    private void setChange(int channel, int x, int y, float before, float after, boolean isReplaced) {
        int i = y * coarseWidth + x;
        if (isReplaced) {
            int lastX = (int) ((x + 0.5) * last.width() / coarseWidth);
            int lastY = (int) ((y + 0.5) * last.height() / coarseHeight);
            added[channel][i] = after + Math.max(0, value(last, channel, lastX, lastY) - before);
        } else {
            ratio[channel][i] = after < before ? after / before : 1;
            added[channel][i] = Math.max(0, after - before);
        }
    }

    private boolean differsNear(Film before, Film after, int x, int y) {
        for (int row = Math.max(0, y - 1); row <= Math.min(coarseHeight - 1, y + 1); row++) {
            for (int column = Math.max(0, x - 1); column <= Math.min(coarseWidth - 1, x + 1); column++) {
                if (before.red(column, row) != after.red(column, row) || before.green(column, row) != after.green(column, row)
                        || before.blue(column, row) != after.blue(column, row)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static float value(Film film, int channel, int x, int y) {
        return channel == 0 ? film.red(x, y) : channel == 1 ? film.green(x, y) : film.blue(x, y);
    }

    private Film estimate() {
        float[][][] tiles = new float[3][last.tileCount()][];
        IntStream.range(0, last.tileCount()).parallel().forEach(tile -> {
            tiles[0][tile] = estimate(tile, last.red(tile), 0);
            tiles[1][tile] = estimate(tile, last.green(tile), 1);
            tiles[2][tile] = estimate(tile, last.blue(tile), 2);
        });
        return new Film(last.width(), last.height(), tiles[0], tiles[1], tiles[2]);
    }

    private float[] estimate(int tile, float[] lastTile, int channel) {
        float[] result = new float[Film.TILE_PIXELS];
        int left = tile % last.tilesX() * Film.TILE_SIZE;
        int top = tile / last.tilesX() * Film.TILE_SIZE;
        for (int y = 0; y < Math.min(Film.TILE_SIZE, last.height() - top); y++) {
            float row = position(top + y, last.height(), coarseHeight);
            int above = (int) row * coarseWidth;
            int below = Math.min((int) row + 1, coarseHeight - 1) * coarseWidth;
            float lower = row - (int) row;
            for (int x = 0; x < Math.min(Film.TILE_SIZE, last.width() - left); x++) {
                float column = position(left + x, last.width(), coarseWidth);
                int before = (int) column;
                int next = Math.min(before + 1, coarseWidth - 1);
                float share = column - before;
                int i = y * Film.TILE_SIZE + x;
                float factor = mix(mix(ratio[channel][above + before], ratio[channel][above + next], share),
                        mix(ratio[channel][below + before], ratio[channel][below + next], share), lower);
                float light = mix(mix(added[channel][above + before], added[channel][above + next], share),
                        mix(added[channel][below + before], added[channel][below + next], share), lower);
                result[i] = lastTile[i] * factor + light;
            }
        }
        return result;
    }

    /** Returns the position of a pixel's center between coarse centers. */
    private static float position(int pixel, int size, int coarseSize) {
        return Math.clamp((pixel + 0.5f) * coarseSize / size - 0.5f, 0, coarseSize - 1);
    }

    private static float mix(float a, float b, float share) {
        return a + (b - a) * share;
    }
}
