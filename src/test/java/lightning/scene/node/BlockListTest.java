package lightning.scene.node;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import lightning.sample.Slow;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Compares a block list with a plain one, and checks that edits share unedited blocks. */
@Slow
class BlockListTest {
    private static final int MANY = 5 * BlockList.BLOCK_SIZE;

    private static List<Integer> upTo(int size) {
        return IntStream.range(0, size).boxed().toList();
    }

    @Property(tries = 200)
    void splices_matchPlainList(@ForAll @IntRange(max = 2 * MANY) int size, @ForAll @IntRange(min = 1, max = 60) int edits,
            @ForAll @IntRange(max = 3) int bias, @ForAll long seed) {
        var random = new Random(seed);
        List<Integer> plain = new ArrayList<>(upTo(size));
        List<Integer> blocks = BlockList.copyOf(plain);
        for (int e = 0; e < edits; e++) {
            int from = random.nextInt(plain.size() + 1);
            // Splices of all lengths, most of them short; the bias grows or shrinks the lists.
            int to = Math.min(plain.size(), from + random.nextInt(1 << random.nextInt(4 * (bias + 1))));
            List<Integer> replacement = random.ints(random.nextInt(1 << random.nextInt(4 * (4 - bias)))).boxed().toList();
            List<Integer> before = blocks;
            blocks = BlockList.splice(blocks, from, to, replacement);
            int start = BlockList.sharedStart(before, blocks);
            int end = BlockList.sharedEnd(before, blocks);
            assertThat(blocks.subList(0, start)).isEqualTo(before.subList(0, start));
            assertThat(blocks.subList(blocks.size() - end, blocks.size())).isEqualTo(before.subList(before.size() - end, before.size()));
            plain.subList(from, to).clear();
            plain.addAll(from, replacement);
        }
        assertThat(blocks).hasSameSizeAs(plain);
        assertThat(new ArrayList<>(blocks)).isEqualTo(plain);
        assertThat(blocks.equals(plain)).isTrue();
        assertThat(plain.equals(blocks)).isTrue();
        assertThat(blocks.hashCode()).isEqualTo(plain.hashCode());
        for (int i = 0; i < plain.size(); i++) {
            assertThat(blocks.get(i)).isEqualTo(plain.get(i));
        }
    }

    @Property(tries = 50)
    void equalElements_makeEqualLists(@ForAll @IntRange(min = 1, max = MANY) int size, @ForAll @IntRange(max = MANY - 1) int index) {
        List<Integer> elements = BlockList.copyOf(upTo(size));
        int at = index % size;
        List<Integer> same = BlockList.splice(elements, at, at + 1, List.of(at));
        List<Integer> other = BlockList.splice(elements, at, at + 1, List.of(-1));
        assertThat(same).isEqualTo(elements);
        assertThat(other).isNotEqualTo(elements);
        assertThat(BlockList.splice(other, at, at + 1, List.of(at))).isEqualTo(elements);
    }

    @Test
    void singleEdit_sharesOtherBlocks() {
        List<Integer> list = BlockList.copyOf(upTo(MANY));
        for (List<Integer> replacement : List.of(List.<Integer>of(), List.of(-1), List.of(-1, -2))) {
            List<Integer> edited = BlockList.splice(list, MANY / 2, MANY / 2 + 1, replacement);
            assertThat(BlockList.sharedStart(list, edited)).isBetween(MANY / 2 - BlockList.BLOCK_SIZE, MANY / 2);
            assertThat(BlockList.sharedEnd(list, edited)).isBetween(MANY / 2 - BlockList.BLOCK_SIZE, MANY / 2);
        }
    }

    @Test
    void manyDeletions_mergeBlocks() {
        List<Integer> list = BlockList.copyOf(upTo(MANY));
        for (int index = 0; list.size() > MANY / 4; index = (index + 2) % (list.size() - 1)) {
            list = BlockList.splice(list, index, index + 1, List.of());
        }
        List<Integer> edited = BlockList.splice(list, 0, 1, List.of(-1));
        // Only the first block and the blocks merged with it are not shared.
        assertThat(list.size() - BlockList.sharedEnd(list, edited)).isGreaterThanOrEqualTo(BlockList.BLOCK_SIZE / 4);
    }

    @Test
    void copyOfBlockList_isSameInstance() {
        List<Integer> list = BlockList.copyOf(upTo(MANY));
        assertThat(BlockList.copyOf(list)).isSameAs(list);
    }

    @Test
    void list_isImmutableAndRejectsNull() {
        List<Integer> source = new ArrayList<>(upTo(MANY));
        List<Integer> list = BlockList.copyOf(source);
        source.set(0, -1);
        assertThat(list.getFirst()).isZero();
        assertThatThrownBy(() -> list.set(0, 1)).isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> list.get(MANY)).isInstanceOf(IndexOutOfBoundsException.class);
        Integer[] holes = new Integer[MANY];
        assertThatNullPointerException().isThrownBy(() -> BlockList.copyOf(Arrays.asList(holes)));
    }
}
