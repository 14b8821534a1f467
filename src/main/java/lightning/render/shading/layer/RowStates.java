package lightning.render.shading.layer;

/**
 * Transitions of row states, see {@link LightRows}. The loops are separate methods so that the JIT compiles them soon: inside a
 * method that calls vector kernels, they would wait until all of those are inlined.
 */
final class RowStates {
    private RowStates() {}

    /**
     * Moves rows into and out of a light's cone.
     *
     * @param candidates rows that may enter or leave the cone, as {@link RowBits}
     * @param inside     candidates that are in the cone
     * @param facing     rows that face the light
     * @param chosen     receives the rows in the cone without a known shadow ray result; their state is unchanged
     */
    static void moveCone(byte[] state, int rows, int[] candidates, int[] inside, int[] facing, int[] chosen) {
        for (int b = 0; b < RowBits.words(rows); b++) {
            int queried = 0;
            for (int rest = candidates[b]; rest != 0; rest &= rest - 1) {
                int i = Integer.numberOfTrailingZeros(rest);
                int row = b * RowBits.WIDTH + i;
                int rayState = state[row] & LightRows.SHADOW_RAY_MASK;
                if ((inside[b] >>> i & 1) == 0) {
                    state[row] = (byte) (LightRows.OUTSIDE_CONE | rayState);
                } else if (rayState != 0) {
                    state[row] = (byte) (rayState | (rayState == LightRows.UNBLOCKED ? LightRows.LIT : LightRows.SHADOWED));
                } else if ((facing[b] >>> i & 1) == 0) {
                    // It was in a tile that the cone did not reach.
                    state[row] = LightRows.FACING_AWAY;
                } else {
                    queried |= 1 << i;
                }
            }
            chosen[b] = queried;
        }
    }

    /**
     * Writes the states of rows whose shadow rays were cast.
     *
     * @param queried the rows, as {@link RowBits}
     * @param blocked rows from which the light is not visible; may contain others
     */
    static void applyShadowRays(byte[] state, int rows, int[] queried, int[] blocked) {
        for (int b = 0; b < RowBits.words(rows); b++) {
            for (int rest = queried[b]; rest != 0; rest &= rest - 1) {
                int i = Integer.numberOfTrailingZeros(rest);
                state[b * RowBits.WIDTH + i] = (byte) ((blocked[b] >>> i & 1) == 0 ? LightRows.LIT | LightRows.UNBLOCKED
                        : LightRows.SHADOWED | LightRows.BLOCKED);
            }
        }
    }
}
