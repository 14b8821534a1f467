package lightning.render.shading;

/**
 * How rows' states, see {@link LightRows}, change. Loops by themselves, so that they are compiled soon: in a method that calls kernels
 * of lanes they wait until all of these are compiled into it.
 */
final class StateChange {
    private StateChange() {}

    /**
     * Moves rows into and out of a light's cone.
     *
     * @param looked the rows that may enter or leave it, as {@link RowBits}
     * @param inside those of them that are in it
     * @param facing the rows that face the light
     * @param chosen gets those that are in it and whose ways are not known: their state is left as it is
     */
    static void move(byte[] state, int rows, int[] looked, int[] inside, int[] facing, int[] chosen) {
        for (int b = 0; b < RowBits.words(rows); b++) {
            int asked = 0;
            for (int rest = looked[b]; rest != 0; rest &= rest - 1) {
                int i = Integer.numberOfTrailingZeros(rest);
                int row = b * RowBits.WIDTH + i;
                int way = state[row] & LightRows.WAY;
                if ((inside[b] >>> i & 1) == 0) {
                    state[row] = (byte) (LightRows.OUTSIDE | way);
                } else if (way != 0) {
                    state[row] = (byte) (way | (way == LightRows.CLEAR ? LightRows.LIT : LightRows.SHADOWED));
                } else if ((facing[b] >>> i & 1) == 0) {
                    // It was among rows that the cone did not reach at all.
                    state[row] = LightRows.AWAY;
                } else {
                    asked |= 1 << i;
                }
            }
            chosen[b] = asked;
        }
    }

    /**
     * Writes the states of rows whose ways were asked.
     *
     * @param asked   the rows, as {@link RowBits}
     * @param blocked those from which the light is not seen, among others
     */
    static void settle(byte[] state, int rows, int[] asked, int[] blocked) {
        for (int b = 0; b < RowBits.words(rows); b++) {
            for (int rest = asked[b]; rest != 0; rest &= rest - 1) {
                int i = Integer.numberOfTrailingZeros(rest);
                state[b * RowBits.WIDTH + i] = (byte) ((blocked[b] >>> i & 1) == 0 ? LightRows.LIT | LightRows.CLEAR
                        : LightRows.SHADOWED | LightRows.BLOCKED);
            }
        }
    }
}
