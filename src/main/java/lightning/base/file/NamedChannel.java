package lightning.base.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Path;

/**
 * Channel to a file whose exceptions name the file; the system's say only {@code No space left on device}.
 *
 * @param name the file's name for the user
 */
record NamedChannel(FileChannel file, Path name) implements SeekableByteChannel {
    @Override
    public int write(ByteBuffer bytes) throws IOException {
        try {
            return file.write(bytes);
        } catch (IOException e) {
            throw withName(e);
        }
    }

    /** Syncs all written data to disk. */
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
