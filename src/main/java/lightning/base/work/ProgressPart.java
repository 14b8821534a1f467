package lightning.base.work;

/**
 * Progress of a part of a task whose parts have different units. The whole task counts in thousandths of its expected time.
 *
 * @param whole progress of the whole task
 * @param from  share of the time that has passed when the part starts, 0…1
 * @param to    share of the time that has passed when the part ends, 0…1
 */
public record ProgressPart(Progress whole, double from, double to) implements Progress {
    private static final int TOTAL = 1000;

    /** Returns part {@code index} of {@code count} equal parts of this part. */
    public ProgressPart section(int index, int count) {
        return new ProgressPart(whole, from + (to - from) * index / count, from + (to - from) * (index + 1) / count);
    }

    @Override
    public void report(int done, int total) {
        double share = from + (to - from) * done / total;
        whole.report(Math.max(1, (int) Math.floor(share * TOTAL)), TOTAL);
    }

    @Override
    public boolean isCanceled() {
        return whole.isCanceled();
    }

    @Override
    public void tileFinished(int tile, float[][] film) {
        whole.tileFinished(tile, film);
    }

    @Override
    public void raysCast(long count) {
        whole.raysCast(count);
    }
}
