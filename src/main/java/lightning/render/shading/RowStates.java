package lightning.render.shading;

/**
 * How rows' states, see {@link LightRows}, change. Loops by themselves, so that they are compiled soon: in a method that calls kernels
 * of lanes they wait until all of these are compiled into it.
 */
final class RowStates {
    private RowStates() {}

    /**
     * Moves rows into and out of a light's cone.
     *
     * @param candidates the rows that may enter or leave it, as {@link RowBits}
     * @param inside those of them that are in it
     * @param facing the rows that face the light
     * @param chosen gets those that are in it and whose ways are not known: their state is left as it is
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
                    // It was among rows that the cone did not reach at all.
                    state[row] = LightRows.FACING_AWAY;
                } else {
                    queried |= 1 << i;
                }
            }
            chosen[b] = queried;
        }
    }

    /**
     * Writes the states of rows whose ways were asked.
     *
     * @param queried   the rows, as {@link RowBits}
     * @param blocked those from which the light is not seen, among others
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
