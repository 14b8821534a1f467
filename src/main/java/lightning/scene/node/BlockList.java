package lightning.scene.node;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Objects;
import java.util.RandomAccess;
import java.util.stream.Stream;

/**
 * Immutable list in blocks. A list made by an edit shares all unedited blocks with the original, so that an edit of a long list takes
 * little time and memory. Null elements are not allowed. Short lists are plain ones.
 */
public final class BlockList<E> extends AbstractList<E> implements RandomAccess {
    /** Elements per block; near the square root of the longest lists. */
    static final int BLOCK_SIZE = 512;

    private final Object[][] blocks;
    /** Start of each block, then the number of elements: {@code int[blocks.length + 1]}. */
    private final int[] starts;

    private BlockList(Object[][] blocks) {
        this.blocks = blocks;
        starts = new int[blocks.length + 1];
        for (int b = 0; b < blocks.length; b++) {
            starts[b + 1] = starts[b] + blocks[b].length;
        }
    }

    /** Returns a list of the same elements; the list itself if it is immutable. */
    static <E> List<E> copyOf(Collection<? extends E> elements) {
        if (elements.size() <= BLOCK_SIZE && !(elements instanceof BlockList)) {
            return List.copyOf(elements);
        }
        return elements instanceof BlockList<?> known ? castUnchecked(known) : new BlockList<>(split(elements.toArray()));
    }

    /** Safe because the list is immutable. */
    @SuppressWarnings("unchecked")
    private static <E> List<E> castUnchecked(List<?> list) {
        return (List<E>) list;
    }

    /** Returns an immutable list in which {@code replacement} replaces the elements {@code from} to {@code to − 1}. */
    static <E> List<E> splice(List<E> list, int from, int to, Collection<? extends E> replacement) {
        if (list instanceof BlockList<E> blocks && list.size() - (to - from) + replacement.size() > BLOCK_SIZE / 2) {
            return blocks.splice(from, to, replacement.toArray());
        }
        return castUnchecked(BlockList.<Object>copyOf(Arrays.asList(splice(list.toArray(), from, to, replacement.toArray()))));
    }

    private BlockList<E> splice(int from, int to, Object[] replacement) {
        int first = blockOf(from);
        int end = blockOf(Math.max(from, to - 1)) + 1;
        if (starts[end] - starts[first] - (to - from) + replacement.length < BLOCK_SIZE / 4) {
            // Merges a block that has become small with its neighbors.
            first = Math.max(0, first - 1);
            end = Math.min(blocks.length, end + 1);
        }
        Object[] old = Stream.of(blocks).skip(first).limit(end - first).flatMap(Stream::of).toArray();
        Object[][] result = split(splice(old, from - starts[first], to - starts[first], replacement));
        return new BlockList<>((Object[][]) splice(blocks, first, end, result));
    }

    private static Object[] splice(Object[] elements, int from, int to, Object[] replacement) {
        Object[] result = Arrays.copyOf(elements, elements.length - (to - from) + replacement.length);
        System.arraycopy(replacement, 0, result, from, replacement.length);
        System.arraycopy(elements, to, result, from + replacement.length, elements.length - to);
        return result;
    }

    /** Splits into blocks of nearly equal length. */
    private static Object[][] split(Object[] elements) {
        int count = (elements.length + BLOCK_SIZE - 1) / BLOCK_SIZE;
        Object[][] blocks = new Object[count][];
        for (int b = 0; b < count; b++) {
            blocks[b] = Arrays.copyOfRange(elements, blockStart(elements.length, b, count), blockStart(elements.length, b + 1, count),
                    Object[].class);
            for (Object element : blocks[b]) {
                Objects.requireNonNull(element);
            }
        }
        return blocks;
    }

    private static int blockStart(int length, int block, int count) {
        return (int) ((long) length * block / count);
    }

    /**
     * Returns the block of an element; the last block for an index after the end. Searches from the position that equal block lengths would
     * give.
     */
    private int blockOf(int index) {
        int last = blocks.length - 1;
        int block = Math.min(last, (int) ((long) index * blocks.length / size()));
        while (index < starts[block]) {
            block--;
        }
        while (block < last && index >= starts[block + 1]) {
            block++;
        }
        return block;
    }

    @Override
    @SuppressWarnings("unchecked")
    public E get(int index) {
        Objects.checkIndex(index, size());
        int block = blockOf(index);
        return (E) blocks[block][index - starts[block]];
    }

    @Override
    public int size() {
        return starts[blocks.length];
    }

    @Override
    public Iterator<E> iterator() {
        return new Iterator<>() {
            private int block;
            private int offset;

            @Override
            public boolean hasNext() {
                return block < blocks.length;
            }

            @Override
            @SuppressWarnings("unchecked")
            public E next() {
                if (!hasNext()) {
                    throw new NoSuchElementException();
                }
                Object[] elements = blocks[block];
                Object next = elements[offset++];
                if (offset == elements.length) {
                    offset = 0;
                    block++;
                }
                return (E) next;
            }
        };
    }

    /** Returns the length of a common prefix, as far as it is known without comparing elements. */
    public static int sharedStart(List<?> a, List<?> b) {
        if (!(a instanceof BlockList<?> one) || !(b instanceof BlockList<?> other)) {
            return 0;
        }
        int minBlocks = Math.min(one.blocks.length, other.blocks.length);
        int shared = 0;
        while (shared < minBlocks && one.blocks[shared] == other.blocks[shared]) {
            shared++;
        }
        return one.starts[shared];
    }

    /** Returns the length of a common suffix, as far as it is known without comparing elements. */
    public static int sharedEnd(List<?> a, List<?> b) {
        if (!(a instanceof BlockList<?> one) || !(b instanceof BlockList<?> other)) {
            return 0;
        }
        int from = one.blocks.length;
        int fromOther = other.blocks.length;
        while (from > 0 && fromOther > 0 && one.blocks[from - 1] == other.blocks[fromOther - 1]) {
            from--;
            fromOther--;
        }
        return one.size() - one.starts[from];
    }

    @Override
    public boolean equals(Object o) {
        if (!(o instanceof BlockList<?> other) || size() != other.size()) {
            return super.equals(o);
        }
        int end = size() - sharedEnd(this, other);
        for (int i = sharedStart(this, other); i < end; i++) {
            if (!get(i).equals(other.get(i))) {
                return false;
            }
        }
        return true;
    }

    @Override
    public int hashCode() {
        return super.hashCode();
    }
}
