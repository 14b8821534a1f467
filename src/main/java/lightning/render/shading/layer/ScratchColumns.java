package lightning.render.shading.layer;

import java.util.ArrayList;
import java.util.List;
import lightning.render.shading.TermKernel;

/** Allocator of scratch columns, which are reused after {@link #reset}. */
public final class ScratchColumns implements ColumnAllocator {
    private final List<float[]> floats = new ArrayList<>();
    private final List<byte[]> states = new ArrayList<>();
    private final List<short[]> shorts = new ArrayList<>();
    private int shortsUsed;
    private int floatsUsed;
    private int statesUsed;

    /** Releases all columns. */
    public void reset() {
        floatsUsed = 0;
        statesUsed = 0;
        shortsUsed = 0;
    }

    @Override
    public float[] floats(int rows) {
        if (floatsUsed == floats.size()) {
            floats.add(new float[TermKernel.MAX_ROWS]);
        }
        return floats.get(floatsUsed++);
    }

    @Override
    public byte[] states(int rows) {
        if (statesUsed == states.size()) {
            states.add(new byte[TermKernel.MAX_ROWS]);
        }
        return states.get(statesUsed++);
    }

    @Override
    public short[] shorts(int rows) {
        if (shortsUsed == shorts.size()) {
            shorts.add(new short[TermKernel.MAX_ROWS]);
        }
        return shorts.get(shortsUsed++);
    }
}
