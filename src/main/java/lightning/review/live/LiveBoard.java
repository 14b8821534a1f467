package lightning.review.live;

import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/** The newest state and picture of a live review, on which the connections of pages wait. What is outdated is never sent. Thread-safe. */
final class LiveBoard {
    private long stateNumber;
    private long pictureNumber;
    private boolean isClosed;
    private String state = "{}";
    private @Nullable LivePicture picture;
    private @Nullable LivePicture previous;

    /**
     * News for a connection.
     *
     * @param state JSON of the state if it is new
     * @param isNewPicture true if there is a picture that was not announced
     */
    record News(long stateNumber, long pictureNumber, @Nullable String state, boolean isNewPicture, boolean isClosed) {
        static final News NONE = new News(0, 0, null, false, false);
    }

    synchronized void show(String newState) {
        if (!newState.equals(state)) {
            state = newState;
            stateNumber++;
            notifyAll();
        }
    }

    synchronized void show(LivePicture newPicture) {
        previous = picture;
        picture = newPicture;
        pictureNumber++;
        notifyAll();
    }

    synchronized @Nullable LivePicture picture() {
        return picture;
    }

    /** Returns the text of a layer of the newest picture, or of the one before, which a page may be reading; null for another one. */
    synchronized byte @Nullable [] layer(String id) {
        byte[] text = picture == null ? null : picture.layers().get(id);
        return text == null && previous != null ? previous.layers().get(id) : text;
    }

    /** Lets all connections end. */
    synchronized void close() {
        isClosed = true;
        notifyAll();
    }

    /** Waits until something is new, at most a time. */
    synchronized News await(News last, long seconds) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (!isClosed && stateNumber == last.stateNumber && pictureNumber == last.pictureNumber) {
            long rest = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            if (rest <= 0) {
                break;
            }
            wait(rest);
        }
        return new News(stateNumber, pictureNumber, stateNumber == last.stateNumber ? null : state, pictureNumber != last.pictureNumber,
                isClosed);
    }
}
