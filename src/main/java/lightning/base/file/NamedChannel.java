package lightning.base.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Path;

/** A file being written whose problems name it: those of the system say only {@code No space left on device}. */
final class NamedChannel implements SeekableByteChannel {
    private final FileChannel file;
    private final Path name;

    /** @param name what a user calls the file */
    NamedChannel(FileChannel file, Path name) {
        this.file = file;
        this.name = name;
    }

    @Override
    public int write(ByteBuffer bytes) throws IOException {
        try {
            return file.write(bytes);
        } catch (IOException e) {
            throw withName(e);
        }
    }

    /** Brings all that was written to the disk. */
    void force() throws IOException {
        try {
            file.force(true);
        } catch (IOException e) {
            throw withName(e);
        }
    }

    private IOException withName(IOException e) {
        if (e.getClass() != IOException.class) {
            return e;
        }
        var named = new FileSystemException(name.toString(), null, e.getMessage());
        named.initCause(e);
        return named;
    }

    @Override
    public int read(ByteBuffer bytes) throws IOException {
        return file.read(bytes);
    }

    @Override
    public long position() throws IOException {
        return file.position();
    }

    @Override
    public NamedChannel position(long offset) throws IOException {
        file.position(offset);
        return this;
    }

    @Override
    public long size() throws IOException {
        return file.size();
    }

    @Override
    public NamedChannel truncate(long size) throws IOException {
        file.truncate(size);
        return this;
    }

    @Override
    public boolean isOpen() {
        return file.isOpen();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
