package lightning.accuracy;

/** A picture is not what its level of accuracy promises: it is not worth measuring. */
public final class BrokenPromise extends RuntimeException {
    private static final long serialVersionUID = 1;

    BrokenPromise(String message) {
        super(message);
    }
}
