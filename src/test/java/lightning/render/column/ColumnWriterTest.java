package lightning.render.column;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.foreign.MemorySegment;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Columns come back as they were written, or not at all. */
class ColumnWriterTest {
    private static byte[] written(byte[] bytes, short[] shorts, int[] ints, float[][] floats) throws IOException {
        var out = new ByteArrayOutputStream();
        var writer = new ColumnWriter(Channels.newChannel(out));
        writer.array(bytes);
        writer.longNumber(ints.length);
        writer.array(shorts);
        writer.array(null);
        writer.array(ints);
        writer.arrays(floats);
        writer.arrays(null);
        writer.end();
        return out.toByteArray();
    }

    /** In memory that is no array of bytes, as a mapped file. */
    private static ColumnReader reader(byte[] bytes) throws IOException {
        ByteBuffer direct = ByteBuffer.allocateDirect(bytes.length);
        direct.put(bytes).flip();
        return new ColumnReader(MemorySegment.ofBuffer(direct));
    }

    @Property(tries = 50)
    void columns_comeBackInEveryBit(@ForAll byte[] bytes, @ForAll short[] shorts, @ForAll int[] ints, @ForAll float[] floats,
            @ForAll @IntRange(max = 200_000) int many) throws IOException {
        float[][] columns = {floats, new float[many]};
        ColumnReader in = reader(written(bytes, shorts, ints, columns));
        assertThat(in.array(ElementType.BYTE)).isEqualTo(bytes);
        assertThat(in.longNumber()).isEqualTo(ints.length);
        assertThat(in.shorts()).isEqualTo(shorts);
        assertThat(in.ints()).isNull();
        assertThat(in.ints()).isEqualTo(ints);
        assertThat(in.arrays()).isDeepEqualTo(columns);
        assertThat(in.arrays()).isNull();
        in.end();
    }

    @Property(tries = 50)
    void anyByteThatDiffers_isNoticed(@ForAll byte[] bytes, @ForAll int[] ints, @ForAll int place,
            @ForAll @IntRange(min = 1, max = 255) int by)
            throws IOException {
        byte[] all = written(bytes, new short[] {1}, ints, new float[][] {{2}});
        all[Math.floorMod(place, all.length)] ^= (byte) by;
        assertThatThrownBy(() -> reader(all)).isInstanceOf(IOException.class);
    }

    @Property(tries = 50)
    void readingPastTheEnd_isAnIoException(@ForAll int[] ints) throws IOException {
        ColumnReader in = reader(written(new byte[0], new short[0], ints, new float[0][]));
        assertThatThrownBy(() -> {
            while (true) {
                in.number();
            }
        }).isInstanceOf(IOException.class);
    }
}
