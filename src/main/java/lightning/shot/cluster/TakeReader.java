package lightning.shot.cluster;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.format.jen.FolderReader;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenLimits;
import lightning.scene.shot.Shot;
import lightning.shot.Take;
import lightning.shot.cluster.wire.Bill;
import lightning.shot.cluster.wire.Hash;
import lightning.shot.cluster.wire.WireException;

/** Makes takes of bills. The newest one is kept, and the files that it names, as long as those of the next are the same. */
final class TakeReader {
    private final ContentFolder contents;
    private final ContentFolder.Parts parts;
    private Hash known;
    private Take take;
    private Path folder;
    private FolderReader reader;

    TakeReader(ContentFolder contents, ContentFolder.Parts parts) {
        this.contents = contents;
        this.parts = parts;
    }

    /**
     * The take of a bill.
     *
     * @throws ContentException if its content does not come or is not what the bill says
     * @throws IOException      if its content cannot be kept
     * @throws WireException    if it is no bill
     * @throws JenException     if its text is no scene, or a file that it names cannot be used
     */
    synchronized Take take(Hash bill, int bytes) throws IOException, WireException, JenException {
        if (bill.equals(known)) {
            return take;
        }
        Bill read = Bill.decode(bill(bill, bytes));
        Path place = contents.scene(read, parts);
        if (!place.equals(folder)) {
            reader = new FolderReader(place);
            folder = place;
        }
        String text = Files.readString(contents.file(read.text(), JenLimits.FILE_BYTES, parts));
        JenDocument document = reader.read(text, "the scene");
        take = new Take(document.scene(), document.shot().orElse(Shot.DEFAULT));
        known = bill;
        return take;
    }

    private byte[] bill(Hash hash, int bytes) throws IOException {
        byte[] bill = parts.from(hash, 0);
        if (bill.length != bytes || !Hash.of(bill).equals(hash)) {
            throw new ContentException("expected a bill of " + bytes + " bytes with its hash, found " + bill.length + " bytes");
        }
        return bill;
    }
}
