package lightning.render.match;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.render.relight.LightFilms;

/**
 * Images of a match: contributions of the lights that it may change, and all other light, as means over cells.
 *
 * @param grid    cells
 * @param names   lights that contribute anything, {@code environment} for the environment
 * @param lights  {@code float[channel][cell]} of each
 * @param rest    the picture without them, {@code float[channel][cell]}
 * @param unseen  lights that contribute nothing to the picture
 * @param skipped cells that do not count
 */
record MatchImages(PixelMeans grid, List<String> names, List<float[][]> lights, float[][] rest, List<String> unseen, BitSet skipped) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * @param picture the picture of the contributions, {@code float[channel][cell]}; not modified
     * @param chosen  names of lights; empty for all that shine
     */
    static MatchImages of(MatchContributions contributions, float[][] picture, BitSet skipped, Optional<Set<String>> chosen) {
        float[][] rest = {picture[0].clone(), picture[1].clone(), picture[2].clone()};
        List<String> names = new ArrayList<>();
        List<float[][]> lights = new ArrayList<>();
        List<String> unseen = new ArrayList<>();
        for (String name : LightFilms.names(contributions.scene())) {
            if (chosen.isEmpty() || chosen.get().contains(name)) {
                float[][] image = contributions.image(name);
                if (subtract(image, rest)) {
                    names.add(name);
                    lights.add(image);
                } else {
                    unseen.add(name);
                }
            }
        }
        return new MatchImages(contributions.grid(), List.copyOf(names), List.copyOf(lights), rest, List.copyOf(unseen), skipped);
    }

    /** Returns whether an image that was subtracted has any light. */
    private static boolean subtract(float[][] image, float[][] rest) {
        boolean isSeen = false;
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < rest[c].length; i++) {
                rest[c][i] -= image[c][i];
                isSeen |= image[c][i] > 0;
            }
        }
        return isSeen;
    }
}
