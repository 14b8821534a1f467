package lightning.format.exr;

import java.util.zip.DataFormatException;

/** Check of compressed data. */
final class DamagedData {
    private DamagedData() {}

    /** Rejects data that is damaged. */
    static void rejectIf(boolean isDamaged) throws DataFormatException {
        if (isDamaged) {
            throw new DataFormatException();
        }
    }
}
