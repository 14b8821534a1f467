package lightning.render.match;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.scene.Contribution;

/**
 * Images of a match: contributions of the lights that it may change, and all other light, as means over cells.
 *
 * @param grid    cells
 * @param names   contributions that are seen
 * @param lights  {@code float[channel][cell]} of each
 * @param rest    the picture without them, {@code float[channel][cell]}
 * @param unseen  contributions that are black
 */
record MatchImages(PixelMeans grid, List<Contribution> names, List<float[][]> lights, float[][] rest, List<Contribution> unseen) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * @param picture the picture of the contributions, {@code float[channel][cell]}; not modified
     * @param chosen  contributions; empty for all that shine
     */
    static MatchImages of(MatchContributions contributions, float[][] picture, Optional<Set<Contribution>> chosen) {
        float[][] rest = {picture[0].clone(), picture[1].clone(), picture[2].clone()};
        List<Contribution> names = new ArrayList<>();
        List<float[][]> lights = new ArrayList<>();
        List<Contribution> unseen = new ArrayList<>();
        for (Contribution name : Contribution.shining(contributions.scene())) {
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
        return new MatchImages(contributions.grid(), List.copyOf(names), List.copyOf(lights), rest, List.copyOf(unseen));
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
