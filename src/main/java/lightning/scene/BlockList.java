package lightning.scene;

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
 * An immutable list of many elements, in blocks: one that is made of another by an edit shares all blocks but those that are edited, so
 * that an edit takes little time and little memory however long the list is. None is null. Short lists are plain ones.
 */
final class BlockList<E> extends AbstractList<E> implements RandomAccess {
    /** The elements of a block; near the square root of the longest lists. */
    static final int MOST = 512;

    private final Object[][] blocks;
    /** Where each block begins, and last how many elements there are: {@code int[blocks.length + 1]}. */
    private final int[] starts;

    private BlockList(Object[][] blocks) {
        this.blocks = blocks;
        starts = new int[blocks.length + 1];
        for (int b = 0; b < blocks.length; b++) {
            starts[b + 1] = starts[b] + blocks[b].length;
        }
    }

    /** The same elements; the list itself where it is immutable. */
    static <E> List<E> copyOf(Collection<? extends E> all) {
        if (all.size() <= MOST && !(all instanceof BlockList)) {
            return List.copyOf(all);
        }
        return all instanceof BlockList<?> known ? unchanging(known) : new BlockList<>(cut(all.toArray()));
    }

    /** Nobody writes to the list, so that it is one of whatever all elements are. */
    @SuppressWarnings("unchecked")
    private static <E> List<E> unchanging(List<?> list) {
        return (List<E>) list;
    }

    /** An immutable list that has others in place of the elements {@code from} to {@code to − 1} of one. */
    static <E> List<E> spliced(List<E> list, int from, int to, Collection<? extends E> by) {
        if (list instanceof BlockList<E> blocks && list.size() - (to - from) + by.size() > MOST / 2) {
            return blocks.spliced(from, to, by.toArray());
        }
        return unchanging(BlockList.<Object>copyOf(Arrays.asList(spliced(list.toArray(), from, to, by.toArray()))));
    }

    private BlockList<E> spliced(int from, int to, Object[] by) {
        int first = block(from);
        int behind = block(Math.max(from, to - 1)) + 1;
        if (starts[behind] - starts[first] - (to - from) + by.length < MOST / 4) {
            // A block that has become small is joined to those beside it.
            first = Math.max(0, first - 1);
            behind = Math.min(blocks.length, behind + 1);
        }
        Object[] old = Stream.of(blocks).skip(first).limit(behind - first).flatMap(Stream::of).toArray();
        Object[][] now = cut(spliced(old, from - starts[first], to - starts[first], by));
        return new BlockList<>((Object[][]) spliced(blocks, first, behind, now));
    }

    private static Object[] spliced(Object[] all, int from, int to, Object[] by) {
        Object[] now = Arrays.copyOf(all, all.length - (to - from) + by.length);
        System.arraycopy(by, 0, now, from, by.length);
        System.arraycopy(all, to, now, from + by.length, all.length - to);
        return now;
    }

    /** Blocks of nearly the same length. */
    private static Object[][] cut(Object[] all) {
        int count = (all.length + MOST - 1) / MOST;
        Object[][] blocks = new Object[count][];
        for (int b = 0; b < count; b++) {
            blocks[b] = Arrays.copyOfRange(all, place(all.length, b, count), place(all.length, b + 1, count), Object[].class);
            for (Object element : blocks[b]) {
                Objects.requireNonNull(element);
            }
        }
        return blocks;
    }

    private static int place(int length, int block, int count) {
        return (int) ((long) length * block / count);
    }

    /** The block of an element; the last one's of what is behind all. Blocks are nearly as long, so it is near where it would be then. */
    private int block(int index) {
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
        int block = block(index);
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
            private int at;

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
                Object[] all = blocks[block];
                Object next = all[at++];
                if (at == all.length) {
                    at = 0;
                    block++;
                }
                return (E) next;
            }
        };
    }

    /** How many elements two lists have alike at the start, as far as it is known without a look at them. */
    static int sharedStart(List<?> a, List<?> b) {
        if (!(a instanceof BlockList<?> one) || !(b instanceof BlockList<?> other)) {
            return 0;
        }
        int least = Math.min(one.blocks.length, other.blocks.length);
        int shared = 0;
        while (shared < least && one.blocks[shared] == other.blocks[shared]) {
            shared++;
        }
        return one.starts[shared];
    }

    /** The same at the end. */
    static int sharedEnd(List<?> a, List<?> b) {
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
